//! What each controller's program needs beside the moves: names, numbers, templates.

mod abb;
mod csv;
mod estun;
mod fanuc;
mod kuka;
mod nachi;
pub mod templates;
mod ur;
mod yaskawa;

pub use abb::Abb;
pub use csv::Csv;
pub use estun::Estun;
pub use fanuc::Fanuc;
pub use kuka::Kuka;
pub use nachi::{Nachi, NachiForm};
pub use ur::Ur;
pub use yaskawa::Yaskawa;
