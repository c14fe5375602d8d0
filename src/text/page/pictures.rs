//! The pictures of the page, drawn without a screen.

use crate::picture::{part_with_lines, png, still};
use crate::planning::PlannedJob;
use crate::text::{Sentence as _, say};
use crate::view::{HeadlessGl, StandardView};

/// Pixels of a picture: a little more than the page is wide.
const SIZE: [u32; 2] = [1200, 750];

/// A picture of the page.
pub(super) struct PagePicture {
    /// What it shows.
    pub name: String,
    /// A PNG file.
    pub png: Vec<u8>,
}

/// The planned part from two sides, or why there are none.
pub(super) fn page_pictures(planned: &PlannedJob) -> Result<Vec<PagePicture>, String> {
    let gl = HeadlessGl::new().map_err(|e| e.sentence())?;
    let (scene, bounds) = part_with_lines(planned);
    let views = [(say!(page_picture_surfaces), StandardView::Iso), (say!(page_picture_top), StandardView::Top)];
    let picture = |(name, view)| {
        let image = still(&gl, &scene, bounds, (view, SIZE)).map_err(|e| e.sentence())?;
        Ok(PagePicture { name, png: png(&image).map_err(|e| say!(picture_not_packed, reason = e.to_string()))? })
    };
    views.into_iter().map(picture).collect()
}
