### What the sample parts are and what they show.

sample_workpiece = Test workpiece of P1 (Fig. 2d): upright plate, 100 x 80 x 12 mm, with a lug boss, holes, and a crater beside a square convex plate that blocks the beam along the normal.
sample_worm_gear = Worm gear of P1 (Fig. 2a, 7, 8), diameter 60 mm: 26 helical teeth whose root normals meet the opposite tooth; shaft hole and six pin holes.
sample_acetabular_cup = Acetabular cup of P2: an open sheet, hemisphere of diameter 46 mm on a 5 mm skirt, open rim at z = 0, pole at z = 28.
sample_connecting_rod = Connecting rod of P1 (Fig. 2c): two end rings 110 mm apart and a shank with a pocket on each side.
sample_front_shaft = Front shaft of P1 (Fig. 2b), 180 mm: stepped journal, shaft tube, and a yoke with two ears and coaxial cross holes.
sample_camshaft = Camshaft as in P3, 219 mm: three journals, four lobes a quarter turn apart, keyway and hexagon. A scan of it with one worn lobe comes with the samples.
