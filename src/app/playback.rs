//! The simulation's place in the plan, and how it advances. Target and time go together: with a robot either may be
//! set, and the other follows; without one there is no time, and the target advances at the speed of the spot.

use super::command::Jump;
use super::playback_data::PlaybackData;
use crate::planning::Plan;
use crate::program::Timeline;

/// How long a target is shown if the next is at the same place, s.
const STAY_S: f64 = 0.3;

/// Where the simulation is, and how it advances.
#[derive(Clone, Debug, PartialEq)]
pub struct Playback {
    /// The current target: pass and point.
    pub at: (usize, usize),
    /// Time in the program, s; 0 without a robot.
    pub time_s: f64,
    /// Whether it is playing.
    pub is_playing: bool,
    /// Speed, as a multiple of real time.
    pub speed: f32,
    /// Whether it starts over at the end.
    pub repeats: bool,
    /// Time since the current target was reached, s; without a robot.
    since_target_s: f64,
}

impl Default for Playback {
    fn default() -> Playback {
        Playback::at_speed(1.0)
    }
}

impl Playback {
    /// Before the start, at so many times the real speed.
    pub fn at_speed(speed: f32) -> Playback {
        Playback { at: (0, 0), time_s: 0.0, is_playing: false, speed, repeats: false, since_target_s: 0.0 }
    }

    /// Goes to a target; the time follows.
    pub fn go_to_target(&mut self, at: (usize, usize), data: Option<&PlaybackData>) {
        self.at = at;
        self.time_s = data.map_or(0.0, |m| m.time_of(at));
    }

    /// Goes to a time; the target follows: the one that was reached last.
    pub fn go_to_time(&mut self, time_s: f64, timeline: &Timeline) {
        self.time_s = time_s.clamp(0.0, timeline.total_s());
        let stops = &timeline.stops()[..=timeline.stop_at(self.time_s)];
        self.at = stops.iter().rev().find_map(|s| s.target).unwrap_or((0, 0));
    }

    /// Goes to another target of the plan.
    pub fn jump(&mut self, jump: Jump, plan: &Plan, data: Option<&PlaybackData>) {
        self.go_to_target(after(self.at, jump, plan), data);
    }

    /// Starts or stops; at the end of the program it starts over.
    pub fn play_or_pause(&mut self, timeline: Option<&Timeline>) {
        self.is_playing = !self.is_playing;
        self.since_target_s = 0.0;
        if let Some(timeline) = timeline.filter(|t| self.is_playing && self.time_s >= t.total_s()) {
            self.go_to_time(0.0, timeline);
        }
    }

    /// Goes on by a time, s, of the real clock.
    pub fn advance(&mut self, real_s: f64, plan: &Plan, data: Option<&PlaybackData>) {
        let passed_s = real_s * f64::from(self.speed);
        match data.and_then(|m| m.timeline.as_ref()) {
            Some(timeline) => self.advance_time(passed_s, timeline),
            None => self.advance_targets(passed_s, plan),
        }
    }

    fn advance_time(&mut self, passed_s: f64, timeline: &Timeline) {
        let time_s = self.time_s + passed_s;
        let ended = time_s >= timeline.total_s();
        self.go_to_time(if ended && self.repeats { 0.0 } else { time_s }, timeline);
        self.is_playing = !ended || self.repeats;
    }

    fn advance_targets(&mut self, passed_s: f64, plan: &Plan) {
        self.since_target_s += passed_s;
        while let Some(pass) = plan.passes.get(self.at.0) {
            let point = self.at.1;
            let needed_s = match (pass.targets.get(point), pass.targets.get(point + 1)) {
                (Some(a), Some(b)) => (b.p - a.p).norm() / pass.settings.speed_mm_s,
                _ => STAY_S,
            };
            if self.since_target_s < needed_s {
                break;
            }
            self.since_target_s -= needed_s;
            let next = after(self.at, Jump::NextPoint, plan);
            if next == self.at {
                self.at = (0, 0);
                self.is_playing = self.repeats;
                break;
            }
            self.at = next;
        }
    }
}

/// The target that a jump leads to; there is none before the first and none after the last.
fn after((pass, point): (usize, usize), jump: Jump, plan: &Plan) -> (usize, usize) {
    let count = |pass: usize| plan.passes.get(pass).map_or(0, |p| p.targets.len());
    let last_pass = plan.passes.len().saturating_sub(1);
    let last_of = |pass: usize| (pass, count(pass).saturating_sub(1));
    match jump {
        Jump::NextPoint if point + 1 < count(pass) => (pass, point + 1),
        Jump::NextPoint if pass < last_pass => (pass + 1, 0),
        Jump::NextPoint => (pass, point),
        Jump::PreviousPoint if point > 0 => (pass, point - 1),
        Jump::PreviousPoint if pass > 0 => last_of(pass - 1),
        Jump::PreviousPoint | Jump::FirstPoint => (0, 0),
        Jump::NextPass => ((pass + 1).min(last_pass), 0),
        Jump::PreviousPass => (pass.saturating_sub(1), 0),
        Jump::LastPoint => last_of(last_pass),
    }
}
