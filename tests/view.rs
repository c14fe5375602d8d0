//! The 3D view inside a real eframe app, rendered without a screen.

mod common;

use clearbeam::view::{
    Bounds, Camera, Depth, HeadlessGl, LineItem, LineSegment, MeshItem, PointItem, Projection, Renderer, Scene,
    StandardView, ViewSize, Viewport, ViewportResponse,
};
use common::glow_renderer::{GlowTestRenderer, thread_gl};
use eframe::egui::{self, Event, Modifiers, PointerButton, Pos2, Vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use nalgebra::{Isometry3, Point2, Point3, Translation3, UnitQuaternion, Vector3};
use std::sync::Arc;

const GREEN: [u8; 4] = [40, 160, 90, 255];
const RED: [u8; 4] = [200, 60, 50, 255];
const PANEL_WIDTH: f32 = 180.0;

/// A cube of 40 mm around the origin, facets turned outward.
fn cube(color: [u8; 4]) -> MeshItem {
    let mut positions = Vec::new();
    for axis in 0..3 {
        for sign in [-20.0_f32, 20.0] {
            let corner = |u: f32, v: f32| {
                let mut at = [0.0; 3];
                at[axis] = sign;
                at[(axis + 1) % 3] = u * sign;
                at[(axis + 2) % 3] = v * 20.0;
                at
            };
            let [a, b, c, d] = [corner(-1., -1.), corner(1., -1.), corner(1., 1.), corner(-1., 1.)];
            positions.extend([a, b, c, a, c, d]);
        }
    }
    MeshItem {
        geometry_key: 1,
        positions: Arc::new(positions),
        colors_key: u64::from(u32::from_be_bytes(color)),
        facet_colors: Arc::new(vec![color; 12]),
        edges: None,
        scene_from_item: Isometry3::identity(),
    }
}

fn cube_bounds() -> Bounds {
    Bounds { min: Point3::new(-20.0, -20.0, -20.0), max: Point3::new(20.0, 20.0, 20.0) }
}

fn scene(meshes: Vec<MeshItem>) -> Scene {
    Scene { meshes, ..Scene::default() }
}

/// A panel and the view: the smallest app that has both.
struct TinyApp {
    viewport: Viewport,
    scene: Arc<Scene>,
    clicks: Vec<&'static str>,
    last: Option<ViewportResponse>,
}

impl TinyApp {
    fn new(cc: &eframe::CreationContext<'_>) -> Self {
        let gl = cc.gl.clone().expect("the harness hands out its context");
        let mut viewport = Viewport::new(gl).expect("OpenGL 3.3");
        viewport.name = "3D view".to_owned();
        viewport.labels.name = "View cube".to_owned();
        viewport.labels.faces = ["Front", "Back", "Left", "Right", "Top", "Bottom"].map(str::to_owned);
        viewport.reset(cube_bounds());
        let scene = Arc::new(scene(vec![cube(GREEN)]));
        Self { viewport, scene, clicks: Vec::new(), last: None }
    }
}

impl eframe::App for TinyApp {
    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        egui::Panel::left("list").exact_size(PANEL_WIDTH).resizable(false).show(ui, |ui| {
            ui.heading("Feature surfaces");
            for row in 0..12 {
                ui.label(format!("{row} plane"));
            }
            let _ = ui.button("Export program…");
        });
        egui::CentralPanel::default().frame(egui::Frame::NONE).show(ui, |ui| {
            let seen = self.viewport.show(ui, &self.scene);
            for (what, happened) in
                [("click", seen.clicked_px), ("double", seen.double_clicked_px), ("menu", seen.secondary_clicked_px)]
            {
                if happened.is_some() {
                    self.clicks.push(what);
                }
            }
            assert_eq!(seen.failure, None);
            self.last = Some(seen);
        });
    }
}

fn harness(pixels_per_point: f32) -> Harness<'static, TinyApp> {
    Harness::builder()
        .with_size(Vec2::new(800.0, 500.0))
        .with_pixels_per_point(pixels_per_point)
        .with_step_dt(1.0 / 60.0)
        .with_render_cursor(false)
        .renderer(GlowTestRenderer::new())
        .build_eframe(|cc| TinyApp::new(cc))
}

fn save(picture: &image::RgbaImage, name: &str) {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR"));
    picture.save(folder.join(name)).expect("target/tmp is writable");
}

fn near(pixel: &image::Rgba<u8>, color: [u8; 4], tolerance: i32) -> bool {
    (0..3).all(|i| (i32::from(pixel[i]) - i32::from(color[i])).abs() <= tolerance)
}

#[test]
fn app_renders_panel_and_part_the_same_twice() {
    for scale in [1.0_f32, 2.0] {
        let mut app = harness(scale);
        let first = app.render().expect("renders");
        save(&first, &format!("tiny_app_{scale}x.png"));
        app.state_mut().viewport.look(StandardView::Front);
        app.run();
        let front = app.render().expect("renders");
        save(&front, &format!("tiny_app_front_{scale}x.png"));

        // The middle of the view shows the cube's front in its own colour.
        let px = |points: f32| (points * scale) as u32;
        let middle = front.get_pixel(px(PANEL_WIDTH + 310.0), px(250.0));
        assert!(near(middle, GREEN, 8), "{middle:?}");
        // The panel is egui's, up to its last column, whatever the view did to OpenGL.
        let without_view = app.ctx.global_style().visuals.panel_fill.to_array();
        for y in [px(300.0), px(420.0), px(495.0)] {
            for x in [px(3.0), px(PANEL_WIDTH - 4.0)] {
                assert!(near(front.get_pixel(x, y), without_view, 0), "panel at {x} {y}");
            }
        }
        let background = front.get_pixel(px(PANEL_WIDTH + 60.0), px(250.0));
        assert!(near(background, [43, 49, 58, 255], 4), "{background:?}");

        let mut other = harness(scale);
        assert_eq!(first, other.render().expect("renders"), "two harnesses, one picture");
        app.state_mut().viewport.look(StandardView::Iso);
        app.run();
        assert_eq!(first, app.render().expect("renders"), "there and back, one picture");
    }
}

fn pointer(app: &mut Harness<'static, TinyApp>, pos: Pos2, button: PointerButton, pressed: bool) {
    app.event(Event::PointerMoved(pos));
    app.event(Event::PointerButton { pos, button, pressed, modifiers: Modifiers::NONE });
    app.step();
}

fn drag(app: &mut Harness<'static, TinyApp>, button: PointerButton, by: Vec2) -> Camera {
    let start = Pos2::new(450.0, 300.0);
    pointer(app, start, button, true);
    app.event(Event::PointerMoved(start + by));
    app.step();
    pointer(app, start + by, button, false);
    app.run();
    app.state().viewport.camera
}

#[test]
fn gestures_move_the_camera_and_report_clicks() {
    let mut app = harness(1.0);
    let start = app.state().viewport.camera;

    let orbited = drag(&mut app, PointerButton::Primary, Vec2::new(50.0, 0.0));
    assert!(orbited.yaw_rad < start.yaw_rad, "the part follows the hand");
    assert_eq!(orbited.target, start.target);

    let panned = drag(&mut app, PointerButton::Secondary, Vec2::new(40.0, 10.0));
    assert_ne!(panned.target, orbited.target);
    assert_eq!(panned.yaw_rad, orbited.yaw_rad);
    let again = drag(&mut app, PointerButton::Middle, Vec2::new(-40.0, -10.0));
    assert!((again.target - orbited.target).norm() < 1e-4, "back where it was");
    assert!(app.state().clicks.is_empty(), "no drag is a click: {:?}", app.state().clicks);

    let cursor = Pos2::new(600.0, 200.0);
    app.event(Event::PointerMoved(cursor));
    app.event(Event::MouseWheel {
        source: egui::MouseWheelSource::Wheel,
        unit: egui::MouseWheelUnit::Line,
        delta: Vec2::new(0.0, 2.0),
        phase: egui::TouchPhase::Move,
        modifiers: Modifiers::NONE,
    });
    app.run_steps(8);
    assert!(app.state().viewport.camera.distance_mm < again.distance_mm * 0.95, "zoomed in");

    pointer(&mut app, cursor, PointerButton::Primary, true);
    pointer(&mut app, cursor, PointerButton::Primary, false);
    assert_eq!(app.state().clicks, ["click"]);
    let clicked_px = app.state().last.as_ref().and_then(|seen| seen.clicked_px);
    let in_view = Point2::new(f64::from(cursor.x), f64::from(cursor.y));
    let left = app.state().last.as_ref().map_or(0.0, |seen| f64::from(seen.response.rect.min.x));
    assert_eq!(clicked_px, Some(Point2::new(in_view.x - left, in_view.y)));
    pointer(&mut app, cursor, PointerButton::Primary, true);
    pointer(&mut app, cursor, PointerButton::Primary, false);
    assert_eq!(app.state().clicks, ["click", "double"]);
    pointer(&mut app, cursor, PointerButton::Secondary, true);
    pointer(&mut app, cursor, PointerButton::Secondary, false);
    assert_eq!(app.state().clicks, ["click", "double", "menu"]);
}

#[test]
fn view_cube_turns_to_the_face_that_is_clicked() {
    let mut app = harness(1.0);
    app.get_by_label("3D view");
    let cube = app.get_by_label("View cube").rect();
    // In the iso view the front face is on the left, below the middle.
    let front = cube.center() + Vec2::new(-12.0, 12.0);
    pointer(&mut app, front, PointerButton::Primary, true);
    pointer(&mut app, front, PointerButton::Primary, false);
    app.run();
    let camera = app.state().viewport.camera;
    assert_eq!((camera.yaw_rad, camera.pitch_rad), StandardView::Front.angles_rad());
    assert!(app.state().clicks.is_empty(), "the part behind the cube was not clicked");
}

#[test]
fn idle_window_repaints_nothing() {
    let mut app = harness(1.0);
    app.run();
    assert!(!app.ctx.has_requested_repaint());
}

const SIZE_PX: [u32; 2] = [320, 240];

fn front_camera() -> Camera {
    let size = ViewSize::new(320.0, 240.0);
    let mut camera = Camera::fitted(cube_bounds(), size);
    camera.projection = Projection::Parallel;
    camera.look(StandardView::Front);
    camera.fit(&cube_bounds(), size);
    camera
}

#[test]
fn unchanged_scene_is_not_drawn_and_colours_travel_alone() {
    let gl = thread_gl();
    let mut renderer = Renderer::new(gl.gl()).expect("OpenGL 3.3");
    let camera = front_camera();
    let mut draw = |scene: &Scene| renderer.draw(scene, &camera, SIZE_PX).expect("draws");

    let green = scene(vec![cube(GREEN)]);
    assert!(draw(&green));
    assert!(!draw(&green));
    let red = scene(vec![cube(RED)]);
    assert!(draw(&red));
    assert!(near(renderer.read_rgba().get_pixel(160, 120), RED, 8));
    assert_eq!(renderer.upload_count(), 3, "geometry once, two colours");
    assert!(!renderer.draw(&red, &camera, [0, 240]).expect("nothing to draw"));
    assert!(renderer.draw(&red, &camera, [321, 240]).expect("draws"));
    // A part that left and came back is uploaded again: its memory was given up.
    assert!(renderer.draw(&Scene::default(), &camera, SIZE_PX).expect("draws"));
    assert!(renderer.draw(&red, &camera, SIZE_PX).expect("draws"));
    assert_eq!(renderer.upload_count(), 5);
}

#[test]
fn what_moves_is_drawn_elsewhere_and_not_uploaded_again() {
    let gl = thread_gl();
    let mut renderer = Renderer::new(gl.gl()).expect("OpenGL 3.3");
    let camera = front_camera();
    let mut at = |place: Isometry3<f64>| {
        let moved = scene(vec![MeshItem { scene_from_item: place, ..cube(GREEN) }]);
        assert!(renderer.draw(&moved, &camera, SIZE_PX).expect("draws"), "another place is another picture");
        assert_eq!(renderer.upload_count(), 2, "geometry and colours, once");
        renderer.read_rgba()
    };
    let (here, turned) = (
        at(Isometry3::identity()),
        at(Isometry3::from_parts(
            Translation3::identity(),
            UnitQuaternion::from_scaled_axis(Vector3::z() * std::f64::consts::FRAC_PI_2),
        )),
    );
    assert!(near(here.get_pixel(160, 120), GREEN, 8));
    assert!(here.pixels().zip(turned.pixels()).all(|(a, b)| near(a, b.0, 3)), "a turned cube looks the same, lit too");
    let aside = at(Isometry3::translation(200.0, 0.0, 0.0));
    assert!(!near(aside.get_pixel(160, 120), GREEN, 60), "it is gone from the middle");
}

#[test]
fn hidden_facets_lines_and_dots_show_what_they_should() {
    let gl = thread_gl();
    let mut renderer = Renderer::new(gl.gl()).expect("OpenGL 3.3");
    let camera = front_camera();
    let yellow = [250, 220, 60, 255];
    let line = |key, y: f32, z: f32, depth| LineItem {
        key,
        segments: Arc::new(vec![LineSegment { a: [-15., y, z], b: [15., y, z], color: yellow }]),
        width_px: 4.0,
        depth,
        scene_from_item: Isometry3::identity(),
    };
    let dot = PointItem {
        key: 9,
        points: Arc::new(vec![([0.0, -20.0, 12.0], RED)]),
        size_px: 10.0,
        depth: Depth::Tested,
        scene_from_item: Isometry3::identity(),
    };
    let lines = vec![
        line(1, -20.0, 6.0, Depth::Tested), // in the surface: must win
        line(2, 0.0, 0.0, Depth::Tested),   // inside: hidden
        line(3, 0.0, -6.0, Depth::OnTop),   // inside, shown all the same
    ];
    let full = Scene { lines, points: vec![dot], ..scene(vec![cube(GREEN)]) };
    renderer.draw(&full, &camera, SIZE_PX).expect("draws");
    let picture = renderer.read_rgba();
    save(&picture, "strokes.png");
    let size = ViewSize::new(320.0, 240.0);
    let at = |z: f64| {
        let (x, y, _) = camera.project(&Point3::new(0.0, -20.0, z), size).expect("seen");
        *picture.get_pixel(x as u32, y as u32)
    };
    assert!(near(&at(6.0), yellow, 2));
    assert!(near(&at(0.0), GREEN, 8));
    assert!(near(&at(-6.0), yellow, 2));
    assert!(near(&at(12.0), RED, 2));

    // Without its front, the cube shows its back from inside, darker.
    let mut open = cube(GREEN);
    let mut colors = (*open.facet_colors).clone();
    for (color, facet) in colors.iter_mut().zip(open.positions.chunks(3)) {
        if facet.iter().all(|corner| corner[1] < 0.0) {
            color[3] = 0;
        }
    }
    (open.facet_colors, open.colors_key) = (Arc::new(colors), 77);
    renderer.draw(&scene(vec![open]), &camera, SIZE_PX).expect("draws");
    let picture = renderer.read_rgba();
    save(&picture, "open.png");
    let inside = picture.get_pixel(160, 120);
    assert!(inside[1] < GREEN[1] - 20 && inside[1] > 40 && inside[1] > inside[2], "{inside:?}");
}

#[test]
fn contexts_on_many_threads_draw_the_same() {
    let draw = || {
        let gl = HeadlessGl::new().unwrap_or_else(|error| panic!("{error}"));
        let mut renderer = Renderer::new(gl.gl()).expect("OpenGL 3.3");
        let camera = front_camera();
        renderer.draw(&scene(vec![cube(GREEN)]), &camera, SIZE_PX).expect("draws");
        renderer.read_rgba()
    };
    let pictures: Vec<_> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..8).map(|_| scope.spawn(draw)).collect();
        threads.into_iter().map(|thread| thread.join().expect("no thread fails")).collect()
    });
    assert!(pictures.iter().all(|picture| *picture == pictures[0]));
}

#[test]
fn renderer_may_outlive_its_context() {
    for _ in 0..3 {
        let gl = HeadlessGl::new().unwrap_or_else(|error| panic!("{error}"));
        let mut renderer = Renderer::new(gl.gl()).expect("OpenGL 3.3");
        drop(gl);
        assert!(renderer.draw(&scene(vec![cube(RED)]), &front_camera(), SIZE_PX).expect("draws"));
    }
    let (first, second) = (HeadlessGl::new().expect("EGL"), HeadlessGl::new().expect("EGL"));
    first.make_current().expect("still there");
    let mut renderer = Renderer::new(first.gl()).expect("OpenGL 3.3");
    assert!(renderer.draw(&scene(vec![cube(RED)]), &front_camera(), SIZE_PX).expect("draws"));
    assert!(near(renderer.read_rgba().get_pixel(160, 120), RED, 8));
    drop((renderer, second));
}

#[test]
fn light_theme_and_small_views_keep_their_overlays_apart() {
    let mut app = Harness::builder()
        .with_size(Vec2::new(800.0, 500.0))
        .with_theme(egui::Theme::Light)
        .with_render_cursor(false)
        .renderer(GlowTestRenderer::new())
        .build_eframe(|cc| {
            let mut app = TinyApp::new(cc);
            let mesh = cube([120, 150, 210, 255]);
            app.scene = Arc::new(Scene {
                background_top: [238, 241, 245],
                background_bottom: [202, 209, 218],
                ..scene(vec![mesh])
            });
            app.viewport.camera.orbit(-40.0, 20.0);
            app
        });
    app.hover_at(Pos2::new(742.0, 36.0));
    app.run();
    save(&app.render().expect("renders"), "light.png");
    assert!(app.query_by_label("View cube").is_some());
    app.set_size(Vec2::new(PANEL_WIDTH + 120.0, 150.0));
    app.run();
    app.render().expect("renders");
    assert!(app.query_by_label("View cube").is_none(), "no room for the cube");
}
