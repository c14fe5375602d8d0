//! What columns mean: names that programs give to coordinates, normals, colours and intensities.

use super::ScanFileError;

/// What a column of a cloud is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    /// A coordinate, of the axis with this number.
    Place(usize),
    /// A component of the normal.
    Normal(usize),
    /// Red, green or blue.
    Colour(usize),
    /// All three in one number, blue lowest.
    Packed,
    /// How bright the point came back.
    Intensity,
}

impl Role {
    /// The role of a column of that name. In a text it may have a unit in brackets behind it.
    pub fn of(name: &str) -> Option<Role> {
        let name = name.trim().trim_matches('"').to_ascii_lowercase();
        let name = name.split(['[', '(']).next().unwrap_or_default().trim();
        Some(match name {
            "x" | "y" | "z" => Role::Place(usize::from(name.as_bytes()[0] - b'x')),
            "nx" | "normal_x" | "normalx" => Role::Normal(0),
            "ny" | "normal_y" | "normaly" => Role::Normal(1),
            "nz" | "normal_z" | "normalz" => Role::Normal(2),
            "red" | "r" | "diffuse_red" => Role::Colour(0),
            "green" | "g" | "diffuse_green" => Role::Colour(1),
            "blue" | "b" | "diffuse_blue" => Role::Colour(2),
            "rgb" | "rgba" => Role::Packed,
            "intensity" | "scalar_intensity" | "i" | "reflectance" | "quality" => Role::Intensity,
            _ => return None,
        })
    }
}

/// Which columns of a cloud are what.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Roles {
    /// One for each column.
    pub of: Vec<Option<Role>>,
    /// Names of those that are nothing.
    pub unread: Vec<String>,
}

impl Roles {
    /// By the names of the columns. The first of several of one role has it; a normal or colour of fewer than three
    /// columns is none.
    ///
    /// # Errors
    /// [`ScanFileError::NoCoordinates`].
    pub fn named<'n>(names: impl Iterator<Item = &'n str> + Clone) -> Result<Roles, ScanFileError> {
        let mut of: Vec<Option<Role>> = Vec::new();
        for name in names.clone() {
            let role = Role::of(name).filter(|r| !of.contains(&Some(*r)));
            of.push(role);
        }
        let has = |role| of.contains(&Some(role));
        let all = |role: fn(usize) -> Role| (0..3).all(|k| has(role(k)));
        if !all(Role::Place) {
            return Err(ScanFileError::NoCoordinates { columns: names.map(str::to_owned).collect() });
        }
        let (normals, colours) = (all(Role::Normal), all(Role::Colour));
        for role in &mut of {
            let is_kept = match role {
                Some(Role::Normal(_)) => normals,
                Some(Role::Colour(_)) => colours,
                Some(Role::Packed) => !colours,
                _ => true,
            };
            if !is_kept {
                *role = None;
            }
        }
        // An underscore is the name of bytes that only fill.
        let unread = names.zip(&of).filter(|(n, r)| r.is_none() && *n != "_").map(|(n, _)| n.to_owned()).collect();
        Ok(Roles { of, unread })
    }

    /// Whether some column has a role like one of these.
    pub fn any(&self, is: fn(&Role) -> bool) -> bool {
        self.of.iter().flatten().any(is)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_other_programs_are_known_and_the_rest_is_told() {
        let names =
            ["\"X [mm]\"", "Y", "z", "alpha", "scalar_Intensity", "quality", "nx", "ny", "rgba", "r", "G", "blue"];
        let roles = Roles::named(names.into_iter()).expect("it has coordinates");
        assert_eq!(roles.unread, ["alpha", "quality", "nx", "ny", "rgba"]);
        assert_eq!(roles.of[..2], [Some(Role::Place(0)), Some(Role::Place(1))]);
        assert_eq!((roles.of[4], roles.of[11]), (Some(Role::Intensity), Some(Role::Colour(2))));
        assert!(roles.any(|r| matches!(r, Role::Colour(_))) && !roles.any(|r| matches!(r, Role::Normal(_))));
        let none = Roles::named(["x", "y", "height"].into_iter()).expect_err("it has none");
        assert!(matches!(none, ScanFileError::NoCoordinates { columns } if columns == ["x", "y", "height"]));
    }
}
