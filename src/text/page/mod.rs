//! The report as one HTML page for people: to be read, printed and filed without the program. Its figures are those of
//! `report.json`; it is in the language in use, and the same input gives the same page.

mod html;
mod pictures;

use super::notice::notice_line;
use super::report::figures;
use super::scan::scan_lines;
use super::{Naming, Sentence as _, clock, dose_lines, fixed, language, say};
use crate::document::Job;
use crate::part::SurfaceId;
use crate::planning::PlannedJob;
use crate::planning::plan::Plan;
use crate::planning::report::{Notice, PlanFinding, Report, Severity, SurfaceReport, notices_worst_first};
use crate::program::Breakdown;
use html::Html;
use pictures::{PagePicture, page_pictures};

/// What makes the page of a plan that is exported for a job, its pictures drawn: HTML, of the report and the times, which
/// are not known without a robot.
pub fn report_page(planned: &PlannedJob, job: &Job) -> impl Fn(&Report, Option<&Breakdown>) -> String + Sync {
    let pictures = page_pictures(planned);
    move |report, times| page_of(report, (job, &planned.plan), times, &pictures)
}

/// The page. `pictures`: or why there are none.
fn page_of(
    report: &Report,
    (job, plan): (&Job, &Plan),
    times: Option<&Breakdown>,
    pictures: &Result<Vec<PagePicture>, String>,
) -> String {
    let naming = Naming::of(job);
    let written = report.written.as_ref();
    let (job_name, part) = written.map_or(("", ""), |w| (&w.job, &w.part));
    let mut page = Html::new(language().code(), &say!(page_title, job = job_name));
    page.paragraph("", &say!(page_about, part, version = env!("CARGO_PKG_VERSION")));
    if let Some(dry_run) = written.and_then(|w| w.dry_run) {
        page.paragraph("undone", &say!(page_dry_run, percent = fixed(dry_run.speed_percent, 0)));
    }
    if let Some(pass) = written.and_then(|w| w.from_pass) {
        page.paragraph("undone", &say!(page_from_pass, pass = super::id(pass)));
    }
    page.section(&say!(page_result));
    if let Some(status) = report.status() {
        page.paragraph("state", &status.sentence());
    }
    let (undone, other) = notices(report, job, &naming);
    list(&mut page, &other);
    pictured(&mut page, pictures);
    page.section(&say!(page_not_done));
    if undone.is_empty() {
        page.paragraph("", &say!(page_all_done));
    }
    list(&mut page, &undone);
    page.section(&say!(page_surfaces));
    page.table(&surface_heads(), &report.surfaces.iter().map(|s| surface_row(s, plan, &naming)).collect::<Vec<_>>());
    page.section(&say!(page_path));
    page.list(figures(report).iter().map(|line| ("", line.as_str())));
    page.section(&say!(page_interference));
    page.table(&[], &interference(report));
    page.section(&say!(page_dose));
    match &report.dose {
        Some(dose) => page.list(dose_lines(dose, &naming).iter().map(|line| ("", line.as_str()))),
        None => page.paragraph("", &say!(page_no_dose)),
    }
    if let Some(scan) = &report.scan {
        page.section(&say!(page_scan));
        page.list(scan_lines(scan).iter().map(|line| ("", line.as_str())));
    }
    page.section(&say!(page_time));
    page.table(&[], &time(report, times));
    page.section(&say!(page_assumed));
    page.table(&[], &super::assumed(&report.findings));
    page.section(&say!(page_files));
    let of_written = written.iter().flat_map(|w| &w.files).map(|f| vec![f.name.clone(), f.sha256.clone()]);
    let read = report.inputs.iter().map(|f| vec![say!(page_read, file = f.name.as_str()), f.sha256.clone()]);
    page.codes(&of_written.chain(read).collect::<Vec<_>>());
    page.finished()
}

/// A line of a list, behind the class of its looks.
type PageLine = (&'static str, String);

/// What is to be known, the worst first: what of it is not done, and the rest.
fn notices(report: &Report, job: &Job, naming: &Naming<'_>) -> (Vec<PageLine>, Vec<PageLine>) {
    let in_file: Vec<_> = report.findings.iter().filter_map(PlanFinding::in_file).cloned().collect();
    let told = |notice: &Notice| {
        let class = match notice.severity() {
            Severity::Unsafe => "unsafe",
            Severity::NotDone => "undone",
            Severity::NotAsWanted | Severity::Found => "",
        };
        (class, notice_line(notice, naming))
    };
    let all = notices_worst_first(report, job, &in_file);
    let (undone, other): (Vec<&Notice>, Vec<&Notice>) = all.iter().partition(|n| n.severity() == Severity::NotDone);
    (undone.into_iter().map(told).collect(), other.into_iter().map(told).collect())
}

fn list(page: &mut Html, lines: &[PageLine]) {
    if !lines.is_empty() {
        page.list(lines.iter().map(|(class, line)| (*class, line.as_str())));
    }
}

fn pictured(page: &mut Html, pictures: &Result<Vec<PagePicture>, String>) {
    match pictures {
        Ok(pictures) => pictures.iter().for_each(|p| page.picture(&p.name, &p.png)),
        Err(why) => page.paragraph("", &say!(page_no_pictures, why)),
    }
}

fn surface_heads() -> Vec<String> {
    vec![
        say!(page_surface),
        say!(page_area),
        say!(page_power),
        say!(page_speed),
        say!(page_spot),
        say!(page_defocus),
        say!(page_spacing),
        say!(page_passes),
        say!(page_worked),
        say!(page_corrected),
        say!(page_blocked),
        say!(page_missed),
    ]
}

fn surface_row(s: &SurfaceReport, plan: &Plan, naming: &Naming<'_>) -> Vec<String> {
    let settings = plan.passes.iter().find(|p| p.surface == s.surface).map(|p| p.settings);
    let set = |figure: fn(&crate::beam::ProcessSettings) -> f64| {
        settings.as_ref().map_or_else(|| "–".into(), |settings| super::exact(figure(settings)))
    };
    let spacing = match (s.spacing_min_mm, s.spacing_max_mm) {
        (Some(least), Some(most)) => format!("{}–{}", fixed(least, 2), fixed(most, 2)),
        _ => "–".into(),
    };
    vec![
        naming.surface(SurfaceId(s.surface)),
        fixed(s.area_mm2, 1),
        set(|s| s.power_w),
        set(|s| s.speed_mm_s),
        set(|s| s.spot_mm),
        set(|s| s.defocus_mm),
        spacing,
        s.passes.to_string(),
        fixed(s.work_mm, 1),
        fixed(s.corrected_mm, 1),
        fixed(s.blocked_mm, 1),
        fixed(s.missed_area_mm2, 2),
    ]
}

/// Before and after the correction, and what is proven.
fn interference(r: &Report) -> Vec<Vec<String>> {
    let count = |n: usize| super::number::grouped(n as u64);
    let mut rows = vec![
        vec![say!(page_hits_along_normal), count(r.interfering)],
        vec![say!(page_targets_corrected), count(r.corrected)],
        vec![say!(page_targets_blocked), count(r.blocked)],
        vec![say!(page_targets_all), count(r.points)],
    ];
    if let Some(mm) = r.min_clearance_mm {
        rows.push(vec![say!(page_clearance), say!(page_mm, mm = fixed(mm, 2))]);
    }
    if let Some(proof) = &r.proof {
        rows.push(vec![say!(page_moves_proven), format!("{} / {}", count(proof.proven), count(proof.lit_moves))]);
        rows.push(vec![say!(page_margin), say!(page_mm, mm = fixed(proof.margin_mm, 2))]);
    }
    rows
}

fn time(r: &Report, times: Option<&Breakdown>) -> Vec<Vec<String>> {
    let mut rows = vec![vec![say!(page_time_whole), clock(r.time_s)]];
    if let Some(t) = times {
        let parts = [
            (say!(page_time_work), t.work_s),
            (say!(page_time_travel), t.travel_s),
            (say!(page_time_waiting), t.waiting_s),
        ];
        rows.extend(parts.map(|(name, s)| vec![name, clock(s)]));
    }
    rows
}
