//! Numbers as operators type them: `1.5 cm`, `2*3`, `90deg`, `1,5`.

/// Value in millimetres, degrees, or the bare number; `None` if it cannot be read.
pub fn read(text: &str) -> Option<f64> {
    let text = text.replace(',', ".").replace('−', "-");
    let mut p = Parser { rest: text.trim() };
    let value = p.sum()?;
    p.rest.trim().is_empty().then_some(value).filter(|v| v.is_finite())
}

struct Parser<'a> {
    rest: &'a str,
}

impl Parser<'_> {
    fn take(&mut self, what: &str) -> bool {
        self.rest = self.rest.trim_start();
        let found = self.rest.strip_prefix(what);
        self.rest = found.unwrap_or(self.rest);
        found.is_some()
    }

    fn sum(&mut self) -> Option<f64> {
        let mut value = self.product()?;
        loop {
            if self.take("+") {
                value += self.product()?;
            } else if self.take("-") {
                value -= self.product()?;
            } else {
                return Some(value);
            }
        }
    }

    fn product(&mut self) -> Option<f64> {
        let mut value = self.factor()?;
        loop {
            // Units of speed and area hold these signs themselves.
            if self.take("*") {
                value *= self.factor()?;
            } else if self.take("/") {
                value /= self.factor()?;
            } else {
                return Some(value);
            }
        }
    }

    fn factor(&mut self) -> Option<f64> {
        if self.take("-") {
            return self.factor().map(|v| -v);
        }
        let value = if self.take("(") {
            let v = self.sum()?;
            self.take(")").then_some(v)?
        } else {
            self.number()?
        };
        Some(value * self.unit())
    }

    fn number(&mut self) -> Option<f64> {
        self.rest = self.rest.trim_start();
        let end = self.rest.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(self.rest.len());
        let (number, rest) = self.rest.split_at(end);
        self.rest = rest;
        number.parse().ok()
    }

    fn unit(&mut self) -> f64 {
        const UNITS: [(&str, f64); 16] = [
            ("mm/s", 1.0),
            ("mm²", 1.0),
            ("mm2", 1.0),
            ("mm", 1.0),
            ("cm", 10.0),
            ("µm", 1e-3),
            ("um", 1e-3),
            ("inch", 25.4),
            ("in", 25.4),
            ("\"", 25.4),
            ("m", 1000.0),
            ("deg", 1.0),
            ("°", 1.0),
            ("%", 1.0),
            ("kW", 1000.0),
            ("W", 1.0),
        ];
        UNITS.iter().find(|(name, _)| self.take(name)).map_or(1.0, |(_, f)| *f)
    }
}

#[cfg(test)]
mod tests {
    use super::read;

    #[test]
    fn what_operators_type() {
        let cases = [
            ("1.5 cm", 15.0),
            ("2*3", 6.0),
            ("90deg", 90.0),
            ("1,5", 1.5),
            ("-3 + 1", -2.0),
            ("(1+2)*2 mm", 6.0),
            ("1/4*1 in", 6.35),
            ("3 mm/s", 3.0),
            ("0.5 kW", 500.0),
            ("30 %", 30.0),
        ];
        for (text, value) in cases {
            let found = read(text).expect(text);
            assert!((found - value).abs() < 1e-9, "{text}: {found}");
        }
        for text in ["", "abc", "1..2", "2*", "1/0", "3 apples"] {
            assert_eq!(read(text), None, "{text}");
        }
    }
}
