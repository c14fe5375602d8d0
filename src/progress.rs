//! Progress of long work, and the wish to end it: shared between the thread that works and the one
//! that shows. What is being done is data; its words stand in `text`.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

/// What long work is doing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Activity {
    /// A part's or a job's file is read.
    Reading,
    /// The files of a scan are read.
    ReadingScan,
    /// Its points are cleaned.
    CleaningScan,
    /// It is laid on the part.
    LayingScan,
    /// It is compared with the part.
    ComparingScan,
    /// Patches become surfaces.
    CuttingPatches,
    /// The images of a weld are read.
    ReadingImages,
    /// Its areas are looked for in the grey image.
    MaskingImage,
    /// Its bead is measured.
    MeasuringBead,
    /// Areas that are ground become surfaces.
    CuttingAreas,
    /// The times of their grinding strategies are compared.
    ComparingStrategies,
    /// Facets are welded, oriented and cut into surfaces.
    BuildingPart,
    /// Surfaces are cut otherwise, to bring a part to order that shatters.
    CuttingSurfaces,
    /// Shapes of surfaces are told apart.
    NamingShapes,
    /// Lines are laid on the surfaces.
    LayingLines,
    /// Poses and moves are planned.
    Planning,
    /// The arm's spins and branches are chosen.
    ChoosingSpins,
    /// Moves with the laser off are looked for.
    ConnectingMoves,
    /// The motion of the arm over time is worked out.
    WorkingOutMotion,
    /// Clearances over time are measured.
    MeasuringClearances,
    /// A plan is exported.
    Exporting,
    /// Packing a job with all its files.
    Packing,
    /// The program is written and read back.
    WritingProgram,
    /// Files are put into the folder.
    WritingFiles,
    /// The dose is summed up.
    SummingDose,
    /// What would help is looked for.
    LookingForSuggestions,
    /// Lower speeds are tried, for suggestions.
    TryingSpeeds,
    /// Single changes of the set-up are tried, for suggestions.
    TryingChanges,
    /// A better set-up is looked for.
    LookingForSetup,
    /// Set-ups on a grid are tried.
    TryingSetups,
    /// Set-ups around the best one are tried.
    ImprovingSetup,
    /// Set-ups near the present one are tried.
    TryingSmallChanges,
    /// Some passes are planned with each set-up found.
    PlanningSamples,
}

/// What is being done and how far it is, and whether it should end.
#[derive(Debug, Default)]
pub struct Progress {
    activity: Mutex<Option<Activity>>,
    done: AtomicUsize,
    whole: AtomicUsize,
    cancelled: Arc<AtomicBool>,
    /// Of work that ends by itself: at which look, and how often it has looked.
    ends: Option<(usize, AtomicUsize)>,
}

/// Pieces between two looks of [`Progress::check_at`]: at a microsecond each some milliseconds, of the hundred within
/// which an operator expects an answer.
const PIECES_BETWEEN_LOOKS: usize = 4096;

/// The work was cancelled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cancelled;

impl Progress {
    /// Of work that is cancelled when it looks for the `looks`th time: at the same place each time, where one thread
    /// does it. What it does after that can be told by [`Progress::looks`].
    pub fn ending_after(looks: usize) -> Progress {
        Progress { ends: Some((looks, AtomicUsize::new(0))), ..Progress::default() }
    }

    /// How often work that ends by itself has looked whether it should.
    pub fn looks(&self) -> usize {
        self.ends.as_ref().map_or(0, |(_, looked)| looked.load(Ordering::Relaxed))
    }

    /// Begins something of so many pieces.
    pub fn begin(&self, activity: Activity, whole: usize) {
        if let Ok(mut now) = self.activity.lock() {
            *now = Some(activity);
        }
        self.done.store(0, Ordering::Relaxed);
        self.whole.store(whole, Ordering::Relaxed);
    }

    /// Of work within this one: it ends with this, and what it does is not shown.
    pub fn within(&self) -> Progress {
        Progress { cancelled: self.cancelled.clone(), ..Progress::default() }
    }

    /// One piece is done.
    ///
    /// # Errors
    /// [`Cancelled`] when the work should end.
    pub fn step(&self) -> Result<(), Cancelled> {
        self.done.fetch_add(1, Ordering::Relaxed);
        self.check()
    }

    /// # Errors
    /// [`Cancelled`] when the work should end.
    pub fn check(&self) -> Result<(), Cancelled> {
        if self.goes_on() { Ok(()) } else { Err(Cancelled) }
    }

    /// Looks at every few thousandth of pieces that are numbered on: they take a microsecond or less each.
    ///
    /// # Errors
    /// [`Cancelled`] when the work should end.
    pub fn check_at(&self, piece: usize) -> Result<(), Cancelled> {
        if piece.is_multiple_of(PIECES_BETWEEN_LOOKS) { self.check() } else { Ok(()) }
    }

    /// Whether nobody asked the work to end.
    pub fn goes_on(&self) -> bool {
        if let Some((last, looked)) = &self.ends
            && looked.fetch_add(1, Ordering::Relaxed) + 1 >= *last
        {
            self.cancel();
        }
        !self.cancelled.load(Ordering::Relaxed)
    }

    /// Asks the work to end.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    /// What is being done, and its share done, 0 to 1; `None` before anything has begun.
    pub fn now(&self) -> Option<(Activity, f32)> {
        let whole = self.whole.load(Ordering::Relaxed).max(1);
        let share = self.done.load(Ordering::Relaxed) as f32 / whole as f32;
        let activity = self.activity.lock().ok().and_then(|now| *now)?;
        Some((activity, share.min(1.0)))
    }
}
