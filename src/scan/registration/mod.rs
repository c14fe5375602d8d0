//! Finds the motion that lays a scan on the model.
