//! Clouds of points in the 3D view: what hides them, how they are thinned while the camera moves, what is uploaded, and
//! a scan beside its model in the colours of the deviation.

mod common;

use clearbeam::part::Mesh;
use clearbeam::picture::deviation::{DepthMesh, model_item};
use clearbeam::picture::patches::{PatchOutline, outlines};
use clearbeam::picture::{DeviationScale, ScanLook, ScanPicture};
use clearbeam::scan::Cloud;
use clearbeam::view::{
    Bounds, Camera, CloudItem, Detail, MeshItem, Projection, Renderer, Scene, StandardView, ViewSize, Viewport,
};
use common::glow_renderer::{GlowTestRenderer, thread_gl};
use eframe::egui::{self, Event, Modifiers, PointerButton, Pos2, Vec2};
use egui_kittest::Harness;
use nalgebra::{Isometry3, Point3};
use std::sync::Arc;
use std::time::{Duration, Instant};

const RED: [u8; 4] = [200, 60, 50, 255];
const SIZE_PX: [u32; 2] = [320, 240];

fn save(picture: &image::RgbaImage, name: &str) {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR"));
    picture.save(folder.join(name)).expect("target/tmp is writable");
}

fn is_red(pixel: &image::Rgba<u8>) -> bool {
    (0..3).all(|i| pixel[i].abs_diff(RED[i]) <= 8)
}

fn red_pixels(picture: &image::RgbaImage) -> usize {
    picture.pixels().filter(|p| is_red(p)).count()
}

fn cloud(places: Vec<[f32; 3]>) -> CloudItem {
    CloudItem {
        geometry_key: places.len() as u64,
        colors_key: 1,
        colors: Arc::new(vec![RED; places.len()]),
        places: Arc::new(places),
        size_points: 2.0,
        lift_mm: 0.0,
        fades: false,
        scene_from_item: Isometry3::identity(),
    }
}

/// Points on a sphere around the origin, evenly, in rows as a scanner has them.
fn sphere(count: usize, radius_mm: f64) -> Vec<[f32; 3]> {
    let rows = (count as f64).sqrt();
    let at = |i: usize| {
        let share = (i as f64 + 0.5) / count as f64;
        let z = 1.0 - 2.0 * share;
        // So many turns of a spiral as there are rows.
        let (sin, cos) = libm::sincos(libm::acos(z) * rows * 2.0);
        let r = (1.0 - z * z).sqrt();
        [r * cos, r * sin, z].map(|x| (radius_mm * x) as f32)
    };
    (0..count).map(at).collect()
}

/// A square of 40 mm in the plane y = 0, facing the front camera.
fn wall() -> MeshItem {
    let [a, b, c, d] = [[-20.0, 0.0, -20.0], [20.0, 0.0, -20.0], [20.0, 0.0, 20.0], [-20.0, 0.0, 20.0]];
    MeshItem {
        geometry_key: 1,
        positions: Arc::new(vec![a, b, c, a, c, d]),
        colors_key: 1,
        facet_colors: Arc::new(vec![[40, 160, 90, 255]; 2]),
        edges: None,
        scene_from_item: Isometry3::identity(),
    }
}

fn bounds(half_mm: f64) -> Bounds {
    let corner = Point3::new(half_mm, half_mm, half_mm);
    Bounds { min: -corner, max: corner }
}

fn camera(view: StandardView, half_mm: f64, size_px: [u32; 2]) -> Camera {
    let size = ViewSize::new(f64::from(size_px[0]), f64::from(size_px[1]));
    let mut camera = Camera::fitted(bounds(half_mm), size);
    camera.look(view);
    camera.fit(&bounds(half_mm), size);
    camera
}

fn drawn(renderer: &mut Renderer, scene: &Scene, camera: &Camera) -> image::RgbaImage {
    renderer.draw(scene, camera, SIZE_PX).expect("draws");
    renderer.read_rgba()
}

#[test]
fn points_in_a_surface_are_seen_and_those_behind_it_as_far_as_they_are_lifted() {
    let gl = thread_gl();
    let mut renderer = Renderer::new(gl.gl()).expect("OpenGL 3.3");
    for projection in [Projection::Perspective, Projection::Parallel] {
        // Turned, so that the surface runs through the depths.
        let mut camera = Camera { projection, ..camera(StandardView::Front, 20.0, SIZE_PX) };
        camera.orbit(120.0, 30.0);
        let mut at = |y_mm: f32, lift_mm: f32, alpha: u8| {
            let places = (0..900).map(|i| [(i % 30) as f32 - 14.5, y_mm, (i / 30) as f32 - 14.5]).collect();
            let [r, g, b, _] = RED;
            let colors = Arc::new(vec![[r, g, b, alpha]; 900]);
            let colors_key = u64::from(alpha);
            let geometry_key = u64::from(y_mm.to_bits());
            let item = CloudItem { lift_mm, colors, colors_key, geometry_key, ..cloud(places) };
            let scene = Scene { meshes: vec![wall()], clouds: vec![item], ..Scene::default() };
            drawn(&mut renderer, &scene, &camera)
        };
        let in_surface = red_pixels(&at(0.0, 0.0, 255));
        // Dots of 2 × 2 pixels: those whose sides fall on the pixels' are whole, of others one at least.
        assert!((900..=3600).contains(&in_surface), "{in_surface}");
        assert!(red_pixels(&at(-0.3, 0.0, 255)) >= in_surface * 9 / 10, "before the surface");
        assert_eq!(red_pixels(&at(3.0, 0.0, 255)), 0, "behind it");
        assert!(red_pixels(&at(3.0, 6.0, 255)) >= in_surface * 9 / 10, "lifted");
        assert_eq!(red_pixels(&at(0.0, 0.0, 0)), 0, "hidden");
    }
}

#[test]
fn dots_grow_with_the_displays_scale_and_a_little_with_zoom() {
    let gl = thread_gl();
    let mut renderer = Renderer::new(gl.gl()).expect("OpenGL 3.3");
    let empty = drawn(&mut renderer, &Scene::default(), &Camera::default());
    // Two far ones give the cloud its size.
    let scene = Scene { clouds: vec![cloud(vec![[0.0; 3], [-20.0; 3], [20.0; 3]])], ..Scene::default() };
    let mut side_px = |zoom: f64, px_per_point: f32| {
        let mut camera = camera(StandardView::Front, 20.0, SIZE_PX);
        camera.projection = Projection::Parallel;
        camera.distance_mm /= zoom;
        let detail = Detail { px_per_point, thinned: false };
        renderer.draw_in_detail(&scene, &camera, SIZE_PX, detail).expect("draws");
        let picture = renderer.read_rgba();
        // The middle one alone, by the light it gives: it may lie between pixels.
        let share = |x, y| {
            let [seen, ground] = [&picture, &empty].map(|p| f64::from(p.get_pixel(x, y)[0]));
            (seen - ground) / (f64::from(RED[0]) - ground)
        };
        (90..150).flat_map(|y| (130..190).map(move |x| (x, y))).map(|(x, y)| share(x, y)).sum::<f64>().sqrt()
    };
    let fitted = side_px(1.0, 1.0);
    assert!((1.7..2.8).contains(&fitted), "{fitted}");
    assert!((side_px(1.0, 2.0) / fitted - 2.0).abs() < 0.3);
    assert!((side_px(4.0, 1.0) / fitted - 2.0).abs() < 0.3);
    assert!((side_px(100.0, 1.0) / fitted - side_px(400.0, 1.0) / fitted).abs() < 0.2, "tiles never");
    assert!((side_px(0.5, 1.0) - 2.0).abs() < 0.5, "never smaller");
}

#[test]
fn colours_travel_alone_and_turning_uploads_nothing() {
    let gl = thread_gl();
    let mut renderer = Renderer::new(gl.gl()).expect("OpenGL 3.3");
    let item = cloud(sphere(300_000, 20.0));
    let scene = Scene { clouds: vec![item.clone()], ..Scene::default() };
    let mut camera = camera(StandardView::Front, 20.0, SIZE_PX);
    let whole = drawn(&mut renderer, &scene, &camera);
    assert_eq!(renderer.upload_count(), 2);
    assert!(renderer.thins(&scene));
    let moving = Detail { thinned: true, ..Detail::default() };
    assert!(renderer.draw_in_detail(&scene, &camera, SIZE_PX, moving).expect("draws"), "another picture");
    assert!(!renderer.draw_in_detail(&scene, &camera, SIZE_PX, moving).expect("draws"), "the same again");
    for _ in 0..5 {
        camera.orbit(10.0, 5.0);
        renderer.draw_in_detail(&scene, &camera, SIZE_PX, moving).expect("draws");
    }
    assert_eq!(renderer.upload_count(), 2, "nothing but the camera changed");
    let recolored = CloudItem { colors_key: 2, colors: Arc::new(vec![[1, 2, 3, 255]; 300_000]), ..item };
    let other = drawn(&mut renderer, &Scene { clouds: vec![recolored], ..Scene::default() }, &camera);
    assert_eq!(renderer.upload_count(), 3);
    assert_ne!(whole, other);
    // A cloud that left is forgotten.
    drawn(&mut renderer, &Scene::default(), &camera);
    drawn(&mut renderer, &scene, &camera);
    assert_eq!(renderer.upload_count(), 5);
    // What is small is never thinned, and its picture stays.
    let small = Scene { clouds: vec![cloud(sphere(5000, 20.0))], ..Scene::default() };
    drawn(&mut renderer, &small, &camera);
    assert!(!renderer.thins(&small));
    assert!(!renderer.draw_in_detail(&small, &camera, SIZE_PX, moving).expect("draws"));
}

#[test]
fn fewer_points_cover_the_part_as_evenly_as_all() {
    let gl = thread_gl();
    let mut renderer = Renderer::new(gl.gl()).expect("OpenGL 3.3");
    let scene = Scene { clouds: vec![cloud(sphere(600_000, 20.0))], ..Scene::default() };
    let camera = camera(StandardView::Iso, 20.0, SIZE_PX);
    let whole = drawn(&mut renderer, &scene, &camera);
    let moving = Detail { thinned: true, ..Detail::default() };
    renderer.draw_in_detail(&scene, &camera, SIZE_PX, moving).expect("draws");
    let thinned = renderer.read_rgba();
    save(&whole, "cloud_whole.png");
    save(&thinned, "cloud_thinned.png");
    let in_quarter = |picture: &image::RgbaImage, quarter: u32| {
        let part = picture.enumerate_pixels().filter(|(x, y, _)| (x / 160) + 2 * (y / 120) == quarter);
        part.filter(|(.., p)| is_red(p)).count() as f64
    };
    for quarter in 0..4 {
        let share = in_quarter(&thinned, quarter) / in_quarter(&whole, quarter);
        // Larger dots reach farther over the rim, and it is not smoothed.
        assert!((0.98..1.06).contains(&share), "{share} of quarter {quarter}");
    }
}

/// The view alone.
struct CloudApp {
    viewport: Viewport,
    scene: Arc<Scene>,
}

impl eframe::App for CloudApp {
    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        egui::CentralPanel::default().frame(egui::Frame::NONE).show(ui, |ui| {
            let seen = self.viewport.show(ui, &self.scene);
            assert_eq!(seen.failure, None);
        });
    }
}

/// When the window is painted again by itself.
fn repaint_in(app: &Harness<'_, CloudApp>) -> Duration {
    app.output().viewport_output[&egui::ViewportId::ROOT].repaint_delay
}

#[test]
fn the_view_is_thinned_while_it_turns_and_whole_once_it_rests() {
    let mut app = Harness::builder()
        .with_size(Vec2::new(500.0, 400.0))
        .with_step_dt(1.0 / 60.0)
        .with_render_cursor(false)
        .renderer(GlowTestRenderer::new())
        .build_eframe(|cc| {
            let mut viewport = Viewport::new(cc.gl.clone().expect("a context")).expect("OpenGL 3.3");
            viewport.labels.name = "View cube".to_owned();
            viewport.name = "3D view".to_owned();
            viewport.reset(bounds(20.0));
            // The visible ones are far fewer dots than pixels, so that each one less is seen.
            let mut places = vec![[0.0; 3]; 600_000];
            places.iter_mut().step_by(300).zip(sphere(2000, 20.0)).for_each(|(place, on_sphere)| *place = on_sphere);
            let item = CloudItem { size_points: 1.0, ..cloud(places) };
            CloudApp { viewport, scene: Arc::new(Scene { clouds: vec![item], ..Scene::default() }) }
        });
    app.run();
    // How red the whole picture is: single dots are smoothed.
    let redness = |picture: image::RgbaImage| {
        picture.pixels().map(|p| f64::from(p[0]) - 0.5 * (f64::from(p[1]) + f64::from(p[2]))).map(|r| r.max(0.0)).sum()
    };
    let before: f64 = redness(app.render().expect("renders"));
    let pointer = |app: &mut Harness<'_, CloudApp>, x: f32, pressed: Option<bool>| {
        let pos = Pos2::new(x, 200.0);
        app.event(Event::PointerMoved(pos));
        if let Some(pressed) = pressed {
            let (button, modifiers) = (PointerButton::Primary, Modifiers::NONE);
            app.event(Event::PointerButton { pos, button, pressed, modifiers });
        }
        app.step();
    };
    pointer(&mut app, 100.0, Some(true));
    for step in 1..5 {
        pointer(&mut app, 100.0 + 7.0 * step as f32, None);
    }
    let turning = redness(app.render().expect("renders"));
    assert!(turning < before * 0.8, "{turning} of {before}");
    // A short halt of the hand changes nothing; a longer one does, with the button still down.
    app.run_steps(4);
    let halted = redness(app.render().expect("renders"));
    assert!(halted < before * 0.8, "{halted} of {before}");
    assert!(repaint_in(&app) < Duration::from_secs(1), "the whole picture is asked for");
    app.run_steps(12);
    let rested = redness(app.render().expect("renders"));
    assert!(rested > before * 0.95, "{rested} of {before}");
    pointer(&mut app, 128.0, Some(false));
    app.run_steps(3);
    assert!(repaint_in(&app) > Duration::from_secs(60), "an idle window repaints nothing");
    // A cut is whole at once.
    app.state_mut().viewport.reset(bounds(20.0));
    app.run();
    assert_eq!(redness(app.render().expect("renders")), before);
}

/// A plate of 40 mm with a worn hollow, as a model with a finer middle, and a scan of it.
struct Worn {
    mesh: Mesh,
    vertices: Vec<Point3<f64>>,
    triangles: Vec<[u32; 3]>,
    depth_mm: Vec<f64>,
    cloud: Cloud,
    deviation_mm: Vec<f32>,
}

const DEEPEST_MM: f64 = 0.25;

/// P3's wear, h (1 - (r/R)²)² with R = 12 mm, beside a hump of half its height; not scanned at the right edge.
fn depth_mm(x: f64, y: f64) -> f64 {
    let bump = |dx: f64, r: f64| {
        let s = 1.0 - (dx * dx + y * y) / (r * r);
        if s > 0.0 { s * s } else { 0.0 }
    };
    if x > 17.0 { f64::NAN } else { DEEPEST_MM * (bump(x + 4.0, 12.0) - 0.5 * bump(x - 12.0, 5.0)) }
}

fn worn() -> Worn {
    let corner = |x: f32, y: f32| [20.0 * x, 20.0 * y, 0.0];
    let [a, b, c, d] = [corner(-1., -1.), corner(1., -1.), corner(1., 1.), corner(-1., 1.)];
    let mesh = Mesh::weld(&[[a, b, c], [a, c, d]], 1.0);
    let side = 101_u32;
    let at = |i: u32| -20.0 + 0.4 * f64::from(i);
    let grid = (0..side * side).map(|i| (at(i % side), at(i / side)));
    let vertices = grid.clone().map(|(x, y)| Point3::new(x, y, 0.0)).collect();
    let cell = |i: u32| {
        let [a, b] = [i, i + side];
        [[a, a + 1, b + 1], [a, b + 1, b]]
    };
    let triangles = (0..side * (side - 1)).filter(|i| i % side < side - 1).flat_map(cell).collect();
    let depths = grid.map(|(x, y)| depth_mm(x, y)).collect();
    // Fixed noise of ±0.03 mm.
    let noise = |i: u32| f64::from(i.wrapping_mul(2_654_435_761) >> 16) / 65_536.0 * 0.06 - 0.03;
    let scanned: Vec<(Point3<f64>, f32)> = (0..400 * 400)
        .map(|i| (-20.0 + 0.1 * f64::from(i % 400), -20.0 + 0.1 * f64::from(i / 400), noise(i)))
        .filter(|(x, ..)| *x <= 17.0)
        .map(|(x, y, n)| (Point3::new(x, y, n - depth_mm(x, y)), (n - depth_mm(x, y)) as f32))
        .collect();
    let (points, deviation_mm): (Vec<_>, Vec<_>) = scanned.into_iter().unzip();
    Worn { mesh, vertices, triangles, depth_mm: depths, cloud: Cloud::of_points(&points), deviation_mm }
}

#[test]
fn wear_is_seen_on_the_points_and_on_the_model() {
    let worn = worn();
    let scale = DeviationScale::new(0.2, 0.05);
    let parent =
        vec![0; worn.triangles.len() / 2].into_iter().chain(vec![1; worn.triangles.len() / 2]).collect::<Vec<_>>();
    let fine =
        DepthMesh { vertices: &worn.vertices, triangles: &worn.triangles, parent: &parent, depth_mm: &worn.depth_mm };
    let model = model_item(&worn.mesh, fine, &[], &scale);
    // The outline at the tolerance, where (1 - (r/R)²)² is a fifth.
    let r = 12.0 * (1.0 - (0.05 / DEEPEST_MM).sqrt()).sqrt();
    let around = |i: u32| {
        let (sin, cos) = libm::sincos(f64::from(i) * std::f64::consts::TAU / 90.0);
        Point3::new(r * cos - 4.0, r * sin, 0.0)
    };
    let pieces: Vec<_> = (0..90).map(|i| [around(i), around(i + 1)]).collect();
    let lines = outlines(&[PatchOutline { pieces: &pieces, chosen: false }]);
    let picture = ScanPicture::new(Arc::new(worn.cloud.clone()), 1);
    let look = ScanLook::Deviation { deviation_mm: &worn.deviation_mm, scale };
    let points = picture.item(look, &Isometry3::identity());
    let plain = MeshItem {
        colors_key: 9,
        facet_colors: Arc::new(vec![[128, 130, 134, 255]; model.facet_count()]),
        ..model.clone()
    };

    let gl = thread_gl();
    let mut renderer = Renderer::new(gl.gl()).expect("OpenGL 3.3");
    let size_px = [800, 600];
    let camera = camera(StandardView::Top, 20.0, size_px);
    let size = ViewSize::new(800.0, 600.0);
    let cases = [
        ("wear_on_model", Scene { meshes: vec![model], lines, ..Scene::default() }),
        ("wear_on_points", Scene { meshes: vec![plain], clouds: vec![points], ..Scene::default() }),
    ];
    for (name, scene) in cases {
        renderer.draw(&scene, &camera, size_px).expect("draws");
        let shown = renderer.read_rgba();
        save(&shown, &format!("{name}.png"));
        // What is at a place, by the hue of a small square around it: single points have noise.
        let mean = |x: f64, y: f64| {
            let (x, y, _) = camera.project(&Point3::new(x, y, 0.0), size).expect("seen");
            let square = (0..25).map(|i| shown.get_pixel(x as u32 + i % 5 - 2, y as u32 + i / 5 - 2).0);
            square.fold([0_i32; 3], |sum, p| std::array::from_fn(|k| sum[k] + i32::from(p[k]))).map(|sum| sum / 25)
        };
        let [worst, hump, sound, unseen] = [mean(-4.0, 0.0), mean(12.0, 0.0), mean(-4.0, 17.0), mean(18.5, 0.0)];
        assert!(worst[0] > worst[1] + 60 && worst[2] > worst[1] + 30, "{name}: beyond the limit, {worst:?}");
        let half = mean(-4.0, 6.5);
        assert!(half[0] > half[1] + 30 && half[1] > half[2] + 50, "{name}: missing, {half:?}");
        assert!(hump[2] > hump[0] + 60, "{name}: surplus, {hump:?}");
        assert!(sound[1] >= sound[0] && sound[1] >= sound[2] && sound[0] > 150, "{name}: sound, {sound:?}");
        assert!(unseen.iter().all(|c| (90..150).contains(c)), "{name}: not scanned, {unseen:?}");
    }
}

/// Processor time of this process so far, all threads, ms: on a machine that is shared, wall time says little.
fn cpu_ms() -> f64 {
    let stat = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let after_name = stat.rsplit(')').next().unwrap_or_default();
    let ticks = after_name.split_whitespace().skip(11).take(2).filter_map(|t| t.parse::<f64>().ok());
    ticks.sum::<f64>() * 10.0
}

/// `cargo test --release --test cloud figures -- --ignored --nocapture`: what a picture of a million points
/// (`CLEARBEAM_POINTS`: of so many) costs, beside one of a single point.
#[test]
#[ignore = "figures, not a check"]
fn figures() {
    let gl = thread_gl();
    let mut renderer = Renderer::new(gl.gl()).expect("OpenGL 3.3");
    let size_px = [1600, 1000];
    let counts = std::env::var("CLEARBEAM_POINTS").ok().and_then(|n| n.parse().ok()).unwrap_or(1_000_000);
    for count in [1, counts] {
        let scene = Scene { clouds: vec![cloud(sphere(count, 20.0))], ..Scene::default() };
        let mut camera = camera(StandardView::Iso, 20.0, size_px);
        let (started, before) = (Instant::now(), cpu_ms());
        renderer.draw(&scene, &camera, size_px).expect("draws");
        renderer.read_rgba();
        let wall_ms = started.elapsed().as_secs_f64() * 1e3;
        println!("{count} points, first picture: {wall_ms:.0} ms, {:.0} ms of processor", cpu_ms() - before);
        for (zoom, thinned) in [(1.0, true), (1.0, false), (4.0, true), (4.0, false)] {
            camera.distance_mm /= zoom;
            let detail = Detail { px_per_point: 1.0, thinned };
            let (started, before, rounds) = (Instant::now(), cpu_ms(), 10);
            for _ in 0..rounds {
                camera.orbit(5.0, 1.0);
                renderer.draw_in_detail(&scene, &camera, size_px, detail).expect("draws");
                // Without it the picture may not be there yet. SAFETY: the context is current on this thread.
                unsafe { egui_glow::glow::HasContext::finish(&*gl.gl()) };
            }
            let [wall_ms, cpu_ms] =
                [started.elapsed().as_secs_f64() * 1e3, cpu_ms() - before].map(|ms| ms / f64::from(rounds));
            println!("{count} points, zoom {zoom}, thinned {thinned}: {wall_ms:.1} ms, {cpu_ms:.1} ms of processor");
            camera.distance_mm *= zoom;
        }
    }
}
