//! How far the part as it is lies off the model.
