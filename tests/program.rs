//! The NACHI program, read back: poses, times, outputs, its form, and one small program whole.
//!
//! A pose of the text is the flange in the base, `T`. With the cell's L (laser in the base) and G
//! (part on the flange) the path frame on the part is `F = G⁻¹·T⁻¹·L`, and must be `[n o a | p + D·a]`.

#[path = "common/nachi_text.rs"]
mod nachi_text;
#[path = "common/parts.rs"]
mod parts;

use clearbeam::sample::solids;
use nachi_text::{Line, Lit, frame_on_part, gear, lit, read, text, workpiece};
use nalgebra::Vector3;
use parts::{block, cell, job, near, planned_at};

#[test]
fn poses_put_the_focus_over_the_row_and_times_give_the_speed() {
    for p in [workpiece(), gear()] {
        let (cell, d, speed) = (cell(), p.job.beam.defocus_mm, p.job.beam.speed_mm_s);
        let lit = lit(&p, &read(&text(&p)));
        assert!(lit.len() > 500);
        // 3 decimals of a mm, 4 of a degree, three of each; near β = 90° all three turn about one axis.
        let (turned, moved) = (3.0 * 0.5e-4f64.to_radians(), 3f64.sqrt() * 0.5e-3);
        for Lit { flange, row: t, way } in lit {
            let f = frame_on_part(&cell, &flange);
            let lever = (cell.base_from_laser.isometry().translation.vector - flange.translation.vector).norm();
            let focus = t.p + t.a * d;
            let off = (f.translation.vector - focus.coords).norm();
            assert!(off <= moved + lever * turned, "{off} mm off {t:?}");
            assert!((f.rotation * Vector3::z() - t.a).norm() <= turned, "{t:?}");
            let o = f.rotation * Vector3::y();
            assert!((o - t.o).norm().min((o + t.o).norm()) <= turned, "{o} for {t:?}");
            if let Some((seconds, way)) = way {
                // The least time of four decimals at which the spot is not too fast.
                let over_s = seconds - (way / speed).max(0.001);
                assert!((-1e-8..1e-4 + 1e-9).contains(&over_s), "{seconds} s for {way} mm");
            }
        }
    }
}

#[test]
fn the_text_has_its_form() {
    for p in [workpiece(), gear()] {
        let text = text(&p);
        assert!(text.is_ascii() && text.ends_with("\nEND\n") && text.matches("END\n").count() == 1);
        let is_minus_zero = |n: &str| n.strip_prefix('-').is_some_and(|r| r.bytes().all(|b| b == b'0' || b == b'.'));
        assert!(!text.split([',', '(', ')', '=']).any(is_minus_zero));
        let lines = read(&text);
        let body: Vec<&Line> = lines.iter().filter(|l| !matches!(l, Line::Comment(_))).collect();
        assert!(matches!(body[..2], [Line::Laser(false), Line::Home]), "off, then home");
        let end = &body[body.len() - 4..];
        assert!(matches!(end, [Line::Laser(false), Line::Home, Line::Laser(false), Line::End]), "off, home, off");
        assert!(matches!(body[2], Line::Go(_, None)), "from home by joints");
        let mut is_on = false;
        for line in &lines {
            match line {
                Line::Laser(on) => {
                    assert!(!(is_on && *on), "on twice");
                    is_on = *on;
                }
                Line::Home | Line::End => assert!(!is_on),
                _ => {}
            }
        }
        let passes: Vec<usize> =
            (0..p.plan.passes.len()).filter(|i| !p.plan.passes[*i].lit_pieces().is_empty()).collect();
        let said = |l: &Line| matches!(l, Line::Comment(s) if s.starts_with("pass "));
        assert_eq!(lines.iter().filter(|l| said(l)).count(), passes.len());
        for i in passes {
            let comment = format!("pass {i}, surface {}", p.plan.passes[i].surface);
            assert!(lines.iter().any(|l| matches!(l, Line::Comment(s) if *s == comment)), "{comment}");
        }
        let seconds: f64 = lines.iter().filter_map(|l| if let Line::Go(_, s) = l { *s } else { None }).sum();
        let moves = lines.iter().filter(|l| matches!(l, Line::Go(..))).count();
        assert!((seconds - p.report().time_s).abs() <= moves as f64 * 0.001, "{seconds} {}", p.report().time_s);
    }
}

#[test]
fn zigzag_lines_need_no_half_turn() {
    let plate = block([0.0; 3], [30.0, 20.0, 4.0]);
    for direction in ["x", "y", "1,1,0"] {
        let p = planned_at(&plate, &[[15.0, 10.0, 4.0]], job(direction, 0.7));
        let poses: Vec<_> = read(&text(&p))
            .into_iter()
            .filter_map(|l| if let Line::Go(pose, _) = l { Some(pose) } else { None })
            .collect();
        for w in poses.windows(2) {
            assert!(w[0].rotation.angle_to(&w[1].rotation).to_degrees() < 120.0);
        }
        let backwards = p.plan.passes.windows(2).filter(|w| w[0].targets[0].o.dot(&w[1].targets[0].o) < -0.99).count();
        assert_eq!(backwards + 1, p.plan.passes.len(), "the lines themselves turn");
    }
}

/// One face of a 3 mm cube. By hand: the planes are z = 0.5, 1.5, 2.5; a = x, and the first line runs
/// along x × z = −y, so [n o a] = [z −y x] and the flange, 60 mm from the part, stands at
/// L − (z + 60, −y, x) of the focus: (350 − 60.5, 3, 350 − 23) for the first target (3, 3, 0.5),
/// (350 − 60.5, 0, 350 − 23) for the second, 3 mm and 1 s later. Rz(180°)·Ry(−90°) is [z −y x]ᵀ.
#[test]
fn a_small_program_is_this() {
    let p = planned_at(&solids::cube(3.0), &[[3.0, 1.5, 1.5]], job("z", 1.0));
    near("three lines", p.report().work_mm, 9.0, 1e-12);
    let text = text(&p).replace(env!("CARGO_PKG_VERSION"), "VERSION");
    insta::assert_snapshot!("small_program", text);
}
