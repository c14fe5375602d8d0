//! Files that clouds come in.
