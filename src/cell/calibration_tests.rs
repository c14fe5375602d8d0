//! Exact data gives the exact frame; noise is not made worse; what cannot tell a frame is refused.

use super::*;
use crate::cell::check::FigureError;
use crate::cell::frame::{FrameError, FrameFault};
use crate::cell::{Cell, CellError, Frame};
use proptest::prelude::*;

const TURN: std::ops::Range<f64> = -180.0..180.0;
const PLACE: std::ops::Range<f64> = -800.0..800.0;

fn frame(p: [f64; 6]) -> Isometry3<f64> {
    Frame::new([p[0], p[1], p[2]], [p[3], p[4], p[5]]).isometry()
}

fn any_frame() -> impl Strategy<Value = [f64; 6]> {
    (prop::array::uniform3(PLACE), prop::array::uniform3(TURN)).prop_map(|(p, r)| [p[0], p[1], p[2], r[0], r[1], r[2]])
}

fn same(one: &Isometry3<f64>, two: &Isometry3<f64>, within: f64) -> bool {
    let turned = (one.rotation.to_rotation_matrix().matrix() - two.rotation.to_rotation_matrix().matrix()).norm();
    (one.translation.vector - two.translation.vector).norm() < within && turned < within
}

fn rms(offsets: impl ExactSizeIterator<Item = f64>) -> f64 {
    let n = offsets.len() as f64;
    (offsets.map(|x| x * x).sum::<f64>() / n).sqrt()
}

/// Poses of a flange whose tip touches a point, off by `noise`.
fn touching(tip: &Vector3<f64>, point: &Vector3<f64>, turns: &[[f64; 3]], noise: &[[f64; 3]]) -> Vec<[f64; 6]> {
    turns
        .iter()
        .zip(noise)
        .map(|(turn, noise)| {
            let at = point - rpy::to_rotation(*turn) * tip + Vector3::from(*noise);
            [at.x, at.y, at.z, turn[0], turn[1], turn[2]]
        })
        .collect()
}

proptest! {
    #[test]
    fn three_points_of_a_frame_give_it_back(p in any_frame(), x in 10.0..500.0f64, u in PLACE, v in 10.0..500.0f64) {
        let truth = frame(p);
        let at = |x: f64, y: f64| (truth * Point3::new(x, y, 0.0)).coords.into();
        let fit = three_points(&ThreePoints { origin: at(0.0, 0.0), x: at(x, 0.0), xy: at(u, v) });
        prop_assert!(same(&fit.expect("a frame").frame, &truth, 1e-9));
    }

    #[test]
    fn exact_points_give_the_exact_frame(p in any_frame(), n in 3..12usize, flat in prop::bool::ANY,
                                         m in prop::collection::vec(prop::array::uniform3(-100.0..100.0f64), 12)) {
        let truth = frame(p);
        let model: Vec<Point3<f64>> = m[..n].iter()
            .map(|m| Point3::new(m[0], m[1], if flat { 7.0 } else { m[2] })).collect();
        prop_assume!((model[1] - model[0]).cross(&(model[2] - model[0])).norm() > 2000.0);
        let pairs: Vec<PointPair> = model.iter()
            .map(|q| PointPair { model: q.coords.into(), measured: (truth * q).coords.into() }).collect();
        let fit = best_fit(&pairs).expect("a frame");
        prop_assert!(same(&fit.frame, &truth, 1e-9), "{} for {truth}", fit.frame);
        prop_assert!(fit.residuals_mm.iter().all(|r| *r < 1e-9));
        prop_assert!(fit.frame.rotation.to_rotation_matrix().matrix().determinant() > 0.999);
    }

    /// The fit is the best one: the true frame leaves no less. And it swallows no more than its six
    /// figures can: of n points with noise, 3n − 6 parts in 3n are left.
    #[test]
    fn noise_of_points_is_left_over(p in any_frame(),
                                    m in prop::collection::vec(prop::array::uniform3(-100.0..100.0f64), 60),
                                    noise in prop::collection::vec(prop::array::uniform3(-0.1..0.1f64), 60)) {
        let truth = frame(p);
        let pairs: Vec<PointPair> = m.iter().zip(&noise).map(|(m, e)| {
            let measured = truth * Point3::from(*m) + Vector3::from(*e);
            PointPair { model: *m, measured: measured.coords.into() }
        }).collect();
        let fit = best_fit(&pairs).expect("a frame");
        let left = rms(fit.residuals_mm.iter().copied());
        let put_in = rms(noise.iter().map(|e| Vector3::from(*e).norm()));
        prop_assert!(left <= put_in + 1e-9);
        prop_assert!(left > 0.8 * put_in, "{left} of {put_in}");
        prop_assert!((fit.frame.translation.vector - truth.translation.vector).norm() < 0.3);
    }

    #[test]
    fn exact_touches_give_the_exact_tip(tip in prop::array::uniform3(-300.0..300.0f64), point in prop::array::uniform3(PLACE),
                                        more in prop::collection::vec(prop::array::uniform3(TURN), 0..5)) {
        let (tip, point) = (Vector3::from(tip), Vector3::from(point));
        let mut turns = vec![[0.0, 0.0, 0.0], [0.0, 25.0, 0.0], [0.0, 0.0, 25.0], [60.0, -20.0, 10.0]];
        turns.extend(more);
        let fit = tool_tip(&touching(&tip, &point, &turns, &[[0.0; 3]; 9])).expect("a tip");
        prop_assert!((fit.flange_from_tip - tip).norm() < 1e-9, "{} for {tip}", fit.flange_from_tip);
        prop_assert!((fit.base_from_tip.coords - point).norm() < 1e-9);
        prop_assert!(fit.residuals_mm.iter().all(|r| *r < 1e-9));
    }

    #[test]
    fn noise_of_touches_is_left_over(tip in prop::array::uniform3(-300.0..300.0f64), point in prop::array::uniform3(PLACE),
                                     turns in prop::collection::vec(prop::array::uniform3(TURN), 30),
                                     noise in prop::collection::vec(prop::array::uniform3(-0.1..0.1f64), 30)) {
        let (tip, point) = (Vector3::from(tip), Vector3::from(point));
        let fit = tool_tip(&touching(&tip, &point, &turns, &noise)).expect("a tip");
        let left = rms(fit.residuals_mm.iter().copied());
        let put_in = rms(noise.iter().map(|e| Vector3::from(*e).norm()));
        prop_assert!(left <= put_in + 1e-9 && left > 0.7 * put_in, "{left} of {put_in}");
        prop_assert!((fit.flange_from_tip - tip).norm() < 0.2);
    }
}

#[test]
fn what_tells_no_frame_is_refused_with_what_to_measure() {
    let near = ThreePoints { origin: [0.0; 3], x: [1.0, 0.0, 0.0], xy: [0.0, 50.0, 0.0] };
    assert_eq!(three_points(&near), Err(FitError::XNearOrigin { off_mm: 1.0 }));
    let line = ThreePoints { origin: [0.0; 3], x: [100.0, 0.0, 0.0], xy: [-80.0, 1.0, 0.0] };
    assert_eq!(three_points(&line), Err(FitError::XyNearAxis { off_mm: 1.0 }));
    let (tip, point) = (Vector3::new(10.0, 20.0, 150.0), Vector3::new(400.0, 0.0, 100.0));
    let poses = |turns: &[[f64; 3]]| touching(&tip, &point, turns, &[[0.0; 3]; 9]);
    let few = poses(&[[0.0; 3], [0.0, 30.0, 0.0], [0.0, 0.0, 30.0]]);
    assert_eq!(tool_tip(&few), Err(FitError::FewPoses { count: 3 }));
    let about_z = poses(&[[0.0; 3], [30.0, 0.0, 0.0], [60.0, 0.0, 0.0], [90.0, 0.0, 0.0], [170.0, 0.0, 0.0]]);
    let refused = tool_tip(&about_z).expect_err("refused");
    let FitError::OneDirection { direction: [x, y, z] } = refused else { panic!("{refused}") };
    assert!(x == 0.0 && y == 0.0 && (z.abs() - 1.0).abs() < 1e-9, "{refused}");
    let hardly = poses(&[[0.0; 3], [0.0, 3.0, 0.0], [0.0, 0.0, 3.0], [3.0, 3.0, 0.0]]);
    assert!(matches!(tool_tip(&hardly), Err(FitError::OneDirection { .. })));
    let pair = |x: f64, y: f64| PointPair { model: [x, y, 0.0], measured: [x, y, 5.0] };
    assert_eq!(best_fit(&[pair(0.0, 0.0), pair(90.0, 0.0)]), Err(FitError::FewPairs { count: 2 }));
    let line = [pair(0.0, 0.0), pair(90.0, 0.0), pair(50.0, 0.1), pair(-70.0, 0.0)];
    assert!(matches!(best_fit(&line), Err(FitError::OneLine { side: CalibrationSide::Model, .. })));
    let nan = PointPair { model: [0.0; 3], measured: [f64::NAN, 0.0, 0.0] };
    assert!(matches!(best_fit(&[nan, nan, nan]), Err(FitError::Figure { value }) if value.is_nan()));
}

/// The shipped cell with one frame given in another way.
fn cell_with(frame: &str, text: &str) -> Result<Cell, CellError> {
    let shipped = include_str!("../../assets/cells/mz04.toml");
    let start = shipped.find(&format!("[{frame}]")).expect("there");
    let end = start + shipped[start..].find("\n\n").expect("a next table");
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("cell.toml");
    let text = format!("{}[{frame}]\n{text}\n{}", &shipped[..start], &shipped[end..]);
    std::fs::write(&file, text).expect("written");
    Cell::load(&file)
}

/// What is wrong with a figure of a cell file called `cell.toml`.
fn refused(cell: Result<Cell, CellError>) -> FigureError {
    let CellError::Figure { file, what, .. } = cell.expect_err("refused") else { panic!("no figure") };
    assert!(file.ends_with("cell.toml"), "{file}");
    *what
}

#[test]
fn a_cell_file_takes_measurements_and_gives_them_back() {
    let three = "three_points = { origin = [300.0, 10.0, 100.0], x = [300.0, 90.0, 100.0], xy = [200.0, 50.0, 100.0] }";
    let points = "points = [{ model = [0.0, 0.0, 0.0], measured = [0.0, 0.0, 50.0] }, \
                  { model = [50.0, 0.0, 0.0], measured = [0.0, 50.0, 50.0] }, \
                  { model = [0.0, 50.0, 0.0], measured = [-50.0, 0.0, 50.0] }, \
                  { model = [0.0, 0.0, 50.0], measured = [0.0, 0.0, 100.2] }]";
    let tip = "tip_poses = [[400.0, 0.0, 250.0, 0.0, 0.0, 0.0], [325.0, 0.0, 270.096, 0.0, 30.0, 0.0], \
               [400.0, 75.0, 270.096, 0.0, 0.0, 30.0], [400.0, 0.0, 250.0, 90.0, 0.0, 0.0]]\n\
               rz_ry_rx_deg = [0.0, 45.0, 0.0]";
    let of_tip = cell_with("flange_from_tool", tip).expect("a cell");
    let tool = &of_tip.flange_from_tool;
    assert!((Vector3::from(tool.position_mm) - Vector3::new(0.0, 0.0, 150.0)).norm() < 0.01, "{tool:?}");
    assert_eq!(tool.rz_ry_rx_deg, [0.0, 45.0, 0.0]);
    let of_three = cell_with("base_from_part", three).expect("a cell");
    assert_eq!(of_three.base_from_part.position_mm, [300.0, 10.0, 100.0]);
    assert!((of_three.base_from_part.rz_ry_rx_deg[0] - 90.0).abs() < 1e-9);
    let of_points = cell_with("flange_from_part", points).expect("a cell");
    let notes = of_points.calibrations();
    assert_eq!(notes.len(), 1);
    let note = &notes[0];
    assert_eq!((note.frame, note.method, note.residuals_mm.len()), ("flange_from_part", "points", 4));
    assert!(note.rms_mm > 0.05 && note.rms_mm < 0.1 && note.worst_mm < 0.2 && note.worst_mm > note.rms_mm, "{note:?}");
    for cell in [&of_tip, &of_three, &of_points] {
        let text = toml::to_string(cell).expect("written");
        let back: Cell = toml::from_str(&text).expect("read");
        assert_eq!(&back, cell);
        assert_eq!(back.calibrations(), cell.calibrations());
        let method = cell.calibrations()[0].method;
        assert!(text.contains(method), "{text}");
    }
    let mut moved = of_three;
    moved.base_from_part.position_mm[2] += 1.0;
    assert!(moved.calibrations().is_empty(), "changed figures are no longer those of the fit");
    assert!(!toml::to_string(&moved).expect("written").contains("three_points"));
}

#[test]
fn a_cell_file_with_useless_measurements_says_so() {
    let wrong = |frame, fault| FigureError::Frame(FrameError { frame, fault });
    let half = refused(cell_with("base_from_laser", "position_mm = [0.0, 0.0, 0.0]"));
    assert_eq!(half, wrong("base_from_laser", FrameFault::Keys));
    for (key, value, most) in [("position_mm", 1.1e5, 1e5), ("rz_ry_rx_deg", -1e308, 3600.0)] {
        let three = |of: &str| if of == key { format!("[0.0, {value:?}, 0.0]") } else { "[0.0, 0.0, 0.0]".into() };
        let far = format!("position_mm = {}\nrz_ry_rx_deg = {}", three("position_mm"), three("rz_ry_rx_deg"));
        let fault = FrameFault::Range { key, value, most };
        assert_eq!(refused(cell_with("flange_from_tool", &far)), wrong("flange_from_tool", fault));
    }
    let three = "three_points = { origin = [0, 0, 0], x = [9, 0, 0], xy = [50, 1, 0] }";
    let fault = FrameFault::Fit(FitError::XyNearAxis { off_mm: 1.0 });
    assert_eq!(refused(cell_with("base_from_part", three)), wrong("base_from_part", fault));
    let tip = "tip_poses = [[400.0, 0.0, 250.0, 0.0, 0.0, 0.0], [325.0, 0.0, 270.096, 0.0, 30.0, 0.0], \
               [400.0, 75.0, 270.096, 0.0, 0.0, 30.0], [400.0, 0.0, 250.0, 90.0, 0.0, 0.0]]\n\
               rz_ry_rx_deg = [0.0, 45.0, 0.0]";
    assert_eq!(refused(cell_with("base_from_part", tip)), FigureError::TipPoses { frame: "base_from_part" });
}
