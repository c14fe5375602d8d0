//! Takes out of a cloud what is none of the part.
