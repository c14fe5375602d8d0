//! Window or command line; nothing else.
use clearbeam::part::*;
fn main() {
    for f in std::env::args().skip(1) {
        let t = std::time::Instant::now();
        let p = load(std::path::Path::new(&f), Units::Mm, &Placement::default(), &[]).unwrap();
        let dt = t.elapsed();
        let s = Surfaces::new(&p.mesh, &p.tree, &p.dihedral_deg, &SurfaceRule{angle_deg:20.0,min_area_mm2:0.0,hysteresis_deg:0.0}, &[], &[]);
        let shapes: Vec<_> = s.list.iter().map(|x| Shape::of(&p.mesh, x).word()).collect();
        let c = |w| shapes.iter().filter(|&&x| x==w).count();
        println!("{f}: {} {} {} open {} nm {} dup {} deg {} flip {} surf {} | shells {} | {:?} pl {} cy {} co {} sp {} ff {}", p.mesh.facets.len(), p.mesh.vertices.len(), p.mesh.edges.len(), p.findings.boundary_edges, p.findings.non_manifold_edges, p.findings.duplicate_facets, p.findings.degenerate_facets, p.orientation.flipped_facets, s.list.len(), p.orientation.shells, dt, c("plane"), c("cylinder"), c("cone"), c("sphere"), c("freeform"));
        for l in p.findings.sentences(&p.mesh, &p.orientation) { println!("   {l}"); }
    }
}
