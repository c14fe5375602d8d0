//! A model of a 3MF file: its unit, its objects and what of them is built, as the XML says it.

use super::super::ThreeMfFault;
use super::package::parsed;
use crate::part::units::StatedUnit;
use roxmltree::{Document, Node};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Namespace of the extension by which objects stand in several models.
const PRODUCTION: &str = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";

/// Namespaces that a model may require: the format's own, several models, and materials, which change no shape.
const KNOWN: [&str; 4] = [
    "http://schemas.microsoft.com/3dmanufacturing/core/2015/02",
    PRODUCTION,
    "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07",
];

/// A transform: three rows of what x, y and z become, then what is added.
pub(super) type Transform = [f64; 12];

/// Leaves all where it is.
pub(super) const IDENTITY: Transform = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];

/// An object somewhere.
#[derive(Clone, Debug)]
pub(super) struct Placed {
    /// The entry with its model; `None`: the same.
    pub entry: Option<String>,
    /// Its number there.
    pub object: u32,
    /// Where it stands.
    pub transform: Transform,
}

/// An object.
#[derive(Debug, Default)]
pub(super) struct Object {
    /// Whether it only holds others while they are printed.
    pub is_support: bool,
    /// Its vertices, in the model's unit.
    pub vertices: Vec<[f64; 3]>,
    /// Its triangles, and where each stands in the entry.
    pub triangles: Vec<([usize; 3], usize)>,
    /// Beams of its lattice.
    pub beams: usize,
    /// Objects that it is made of; shared, because an object may be placed many times.
    pub components: Arc<[Placed]>,
}

/// A model.
#[derive(Debug)]
pub(super) struct Model {
    /// The unit of its coordinates.
    pub unit: StatedUnit,
    /// Its objects by their numbers.
    pub objects: BTreeMap<u32, Object>,
    /// What is built.
    pub items: Vec<Placed>,
}

impl Model {
    /// Reads the text of an entry.
    pub fn of(text: &str, entry: &str) -> Result<Model, ThreeMfFault> {
        let document = parsed(text, entry)?;
        let root = document.root_element();
        check_extensions(&root)?;
        let word = root.attribute("unit").unwrap_or("millimeter");
        let unit = StatedUnit::from_word(word).ok_or_else(|| ThreeMfFault::Unit { word: word.into() })?;
        let mut model = Model { unit, objects: BTreeMap::new(), items: Vec::new() };
        let reader = Reader { document: &document };
        for node in elements(&root, "resources").flat_map(|r| r.children()).filter(|n| is(n, "object")) {
            model.objects.insert(reader.whole(&node, "id")?, reader.object(&node)?);
        }
        for node in elements(&root, "build").flat_map(|b| b.children()).filter(|n| is(n, "item")) {
            model.items.push(reader.placed(&node)?);
        }
        Ok(model)
    }
}

/// A model that needs what is not known here would be read as something else than it is.
fn check_extensions(root: &Node<'_, '_>) -> Result<(), ThreeMfFault> {
    for prefix in root.attribute("requiredextensions").unwrap_or_default().split_whitespace() {
        let namespace = root.lookup_namespace_uri(Some(prefix)).unwrap_or(prefix);
        if !KNOWN.contains(&namespace) {
            return Err(ThreeMfFault::Extension { name: namespace.into() });
        }
    }
    Ok(())
}

fn is(node: &Node<'_, '_>, name: &str) -> bool {
    node.is_element() && node.tag_name().name() == name
}

fn elements<'a, 'i>(node: &Node<'a, 'i>, name: &'static str) -> impl Iterator<Item = Node<'a, 'i>> {
    node.children().filter(move |n| is(n, name))
}

struct Reader<'d, 'i> {
    document: &'d Document<'i>,
}

impl Reader<'_, '_> {
    fn fault(&self, node: &Node<'_, '_>) -> ThreeMfFault {
        let line = self.document.text_pos_at(node.range().start).row;
        ThreeMfFault::Value { element: node.tag_name().name().into(), line }
    }

    fn whole(&self, node: &Node<'_, '_>, name: &str) -> Result<u32, ThreeMfFault> {
        node.attribute(name).and_then(|w| w.trim().parse().ok()).ok_or_else(|| self.fault(node))
    }

    fn number(&self, node: &Node<'_, '_>, name: &str) -> Result<f64, ThreeMfFault> {
        node.attribute(name).and_then(|w| w.trim().parse().ok()).ok_or_else(|| self.fault(node))
    }

    fn placed(&self, node: &Node<'_, '_>) -> Result<Placed, ThreeMfFault> {
        let mut transform = IDENTITY;
        if let Some(words) = node.attribute("transform") {
            let numbers: Result<Vec<f64>, _> = words.split_whitespace().map(str::parse).collect();
            let numbers = numbers.ok().filter(|n| n.iter().all(|x| x.is_finite()));
            transform = numbers.and_then(|n| n.try_into().ok()).ok_or_else(|| self.fault(node))?;
        }
        let entry = node.attribute((PRODUCTION, "path")).map(str::to_owned);
        Ok(Placed { entry, object: self.whole(node, "objectid")?, transform })
    }

    fn object(&self, node: &Node<'_, '_>) -> Result<Object, ThreeMfFault> {
        let is_support = matches!(node.attribute("type"), Some("support" | "solidsupport"));
        let components = elements(node, "components").flat_map(|c| c.children()).filter(|n| is(n, "component"));
        let components: Result<Arc<[Placed]>, ThreeMfFault> = components.map(|c| self.placed(&c)).collect();
        let mut object = Object { is_support, components: components?, ..Object::default() };
        let Some(mesh) = elements(node, "mesh").next() else { return Ok(object) };
        for v in elements(&mesh, "vertices").flat_map(|l| l.children()).filter(|n| is(n, "vertex")) {
            object.vertices.push([self.number(&v, "x")?, self.number(&v, "y")?, self.number(&v, "z")?]);
        }
        for t in elements(&mesh, "triangles").flat_map(|l| l.children()).filter(|n| is(n, "triangle")) {
            let corner = |name| self.whole(&t, name).map(|n| n as usize);
            object.triangles.push(([corner("v1")?, corner("v2")?, corner("v3")?], t.range().start));
        }
        object.beams = mesh.descendants().filter(|n| is(n, "beam")).count();
        Ok(object)
    }
}
