//! From the file of a part to a robot program that cleans the chosen surfaces with a laser.
//!
//! Data flows one way, and the rooms stand in that order; a room uses only rooms above it.
//!
//! - [`part`]: the workpiece. Its file (STL, OBJ, PLY, 3MF) becomes a [`part::Part`]: welded topology, outward
//!   winding, the merge tree that gives *feature surfaces* at any crease angle, named shapes, and
//!   rays against all facets.
//! - [`sample`]: parts made by formula: the shipped samples, and solids that tests measure against.
//! - [`scan`]: the part as it is. A [`scan::Cloud`] is cleaned, laid on the model ([`scan::registration`]) and compared with
//!   it ([`scan::deviation`]): what is worn is a patch, which [`part::patched`] makes a surface of.
//! - [`weld`]: beads and ground places in the grey and the depth image of a camera: from pixels by [`weld::masked`] to
//!   points by [`weld::points()`], in the camera's frame.
//! - [`path`]: where the spot travels. Families of section planes, transversal lines walked along
//!   the topology, normals, the dense line, chord error, order, and what no line reaches.
//! - [`beam`]: the tool. Optics, the head, the space they take up at a pose, and clamps, which stand in their way.
//! - [`pose`]: how the beam stands. Interference of beam and head with the part, P1's correction in the
//!   section plane, the search for clearance, the motion between targets, the targets of a [`pose::Pass`]; and an independent
//!   checker that shares no code with the rest.
//! - [`process`]: what the beam does to the surface. The [`process::Light`] of all lit moves lands on fine
//!   samples, a [`process::DoseMap`]; a [`process::Patch`] stays unclean, and says why.
//! - [`cell`]: the robot and where it stands. A [`cell::Setup`] is a [`cell::Cell`] (frames, given or
//!   measured, bodies, outputs, the controllers' templates), a [`cell::Robot`] (kinematics both ways, limits)
//!   and a [`cell::Mount`]: part in hand `T = L·(G·F)⁻¹`, tool in hand `T = B·F·Rot(180°)·H⁻¹`.
//!   [`cell::motion`] chooses spin and branch for all targets together, and says why where it cannot;
//!   [`cell::Collision`] says what touches.
//! - [`program`]: lit pieces joined by connecting moves ([`program::Steps`]), over time
//!   ([`program::Timeline`]), and as neutral lines ([`program::lines()`]). A [`program::Dialect`] writes
//!   them in the words of a controller and reads its text back.
//! - [`document`]: what is saved ([`document::Job`]), edited ([`document::Edit`], [`document::Document`]), and kept
//!   from being lost ([`document::Journal`]).
//! - [`planning`]: what is computed from it by one [`planning::Pipeline`]: planned ([`planning::plan()`]), written
//!   ([`planning::export`]) and compared with what was read ([`planning::verify`]).
//! - [`view`] draws scenes with OpenGL, with or without a screen; [`picture`] says what is in them.
//! - [`text`] makes sentences of what the rooms above find and refuse, in the user's language; the rooms themselves
//!   know no words.
//! - [`mod@file`] reads files that people write, and names them where they are wrong.
//! - [`fit`] brings points onto others by one rigid motion.
//! - [`progress`] is the one thing that all who work long share with who waits for them.
//! - [`cli`] and [`app`] are the two doors: the command line and the window. Nothing imports them.
//!
//! Units: lengths mm, angles degrees, speeds mm/s, times s. Everything up to `program` is in the
//! *part frame*, the file's coordinates after scaling and placement, but for `cell`, whose poses are in
//! the robot's *base*. Names say unit and frame.
//! The same part and job give the same bytes on any number of threads and any machine.
//!
//! ```
//! use clearbeam::cell::Setup;
//! use clearbeam::document::{Job, segmented};
//! use clearbeam::planning::{self, PlanCache, report::Report};
//! use clearbeam::progress::Progress;
//! use clearbeam::part::{Part, Placement, Units};
//! use clearbeam::program::{Dialect, Program, dialects::nachi::NachiDialect, lines};
//! use clearbeam::sample::{solids, stl_bytes};
//!
//! let stl = stl_bytes(&solids::cube(20.0));
//! let part = Part::from_bytes(&stl, Units::Mm, &Placement::default(), &[])?;
//! let mut job = Job::default();
//! let surfaces = segmented(&part, &job);
//! assert_eq!(surfaces.list.len(), 6);
//! let upright = surfaces.list.iter().find(|s| surfaces.normals[s.facets[0] as usize].x > 0.9).unwrap();
//! job.settings.choose([upright.number]);
//! job.layers.spacing_mm = 1.0;
//! let setup = Setup::shipped()?;
//! let plan = planning::plan(&part, &surfaces, &job, &setup, &PlanCache::default(), &Progress::default())?;
//! assert_eq!(plan.passes.len(), 20);
//! let report = Report::new(&plan, &surfaces);
//! assert!((report.work_mm - 20.0 * 20.0).abs() < 1e-9);
//! let lines = lines(&plan.steps, &setup);
//! let program = Program { head: Vec::new(), lines, setup: &setup, wording: clearbeam::text::program_comment };
//! assert!(NachiDialect.write(&program)?[0].text.ends_with("END\n"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod app;
pub mod beam;
pub mod cell;
pub mod cli;
pub mod document;
pub mod file;
pub mod fit;
pub mod number_fields;
pub mod part;
pub mod path;
pub mod picture;
pub mod planning;
pub mod pose;
pub mod process;
pub mod program;
pub mod progress;
pub mod sample;
pub mod scan;
pub mod text;
pub mod view;
pub mod weld;
