//! Accuracy contracts.
