### Comments in robot programs. They are English in every language, and plain ASCII: a controller may show nothing else.

## At the head

comment_part = clearbeam { $version }, part { $part }
comment_surfaces = surfaces { $list }
comment_surfaces_and_more = surfaces { $list } and { $more } more
comment_worked_with = power { $power } W, spot { $spot } mm, defocus { $defocus } mm, speed { $speed } mm/s
comment_worked_with_pulses = power { $power } W at { $frequency } kHz, spot { $spot } mm, defocus { $defocus } mm, speed { $speed } mm/s
comment_ground_disc = grinding disc, speed { $speed } mm/s
comment_ground_disc_force = grinding disc, force { $force } N, speed { $speed } mm/s
comment_ground_belt = grinding belt, speed { $speed } mm/s
comment_ground_belt_force = grinding belt, force { $force } N, speed { $speed } mm/s
comment_laid = direction { $direction }, spacing { $spacing } mm, { $order }
comment_targets = { $all } targets, { $corrected } corrected, { $blocked } blocked and left out
comment_without_robot = Flange poses, { $mount }; reach and limits are NOT checked
comment_robot = { $name }, { $mount }
comment_unchecked = Figures of the robot that nobody has checked: { $figures }
comment_file_unit = CAUTION: the part file states { $stated }, it was read in { $units }
comment_file_dropped = CAUTION: bad facets left out of the part file: { $count }
comment_file_count = CAUTION: the part file promises { $promised } facets, { $read } were read
comment_file_not_read = CAUTION: left out of the part file, being no facets: { $count }
comment_file_passed_over = CAUTION: bytes of the part file passed over: { $count } from byte { $at }
comment_file_joined = Solids of the part file joined into one part: { $count }
comment_never_run = Not verified on a { $dialect } controller: run it dry first, with { $dry_run } (clearbeam plan --dry-run)
comment_dry_run = DRY RUN: every output stays off, and all moves go at { $percent } per cent of the program's speed
comment_from_pass = goes on from pass { $number }: the passes before it are done

## What of a dialect is not verified: one comment a line, as long as the controller takes them

comment_caveat_rapid =
    Not verified on a controller: configurations (ConfL is off), speeds of joint moves,
    robhold of tool and work object, rounding by zones. Targets are the focus on the part:
    tool data and work object below are the cell's frames. Set the load that the robot
    carries, and run at 100 per cent: with \T each move takes its time.
comment_caveat_erp =
    UNVERIFIED: no controller of this make was at hand; every word is from public examples.
    Outputs, levels, frames and zones are templates of the cell file. Try it in the simulator.
    Flange poses in World with the null tool; speeds give each move its time at 100 per cent.
comment_caveat_krl =
    Not verified on a controller: BAS and INTERRUPT of the head, rounding by C_DIS,
    $VEL.ORI1 and $VEL.ORI2 of moves that turn on the spot, status and turn of PTP
    to poses. Flange poses in the robot's base, tool and base null: the speeds give
    each move its time at 100 per cent override.
comment_caveat_inform =
    Not verified on a controller
    RCONF, VR, PL, relative job,
    and where the base frame has
    its origin: base_height_mm.
    Poses of the flange in BASE,
    so the tool has to be null.
    Speeds give each move its
    time at 100 per cent.

## Between the moves

comment_pass = pass { $number }, surface { $surface }
comment_pass_of_layer = pass { $number }, surface { $surface }, layer { $layer }
comment_force_on = press with { $force } N
comment_force_off = press no more
comment_set_power = set power to { $value } W by hand
comment_set_frequency = set frequency to { $value } kHz by hand
