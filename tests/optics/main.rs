//! What models and films are made of: elementary functions, media, colours, stacks of layers, and
//! the reference.

mod color;
mod dispersion;
mod elementary;
mod energy;
mod media;
mod reference;
mod stack;
mod stacks;
mod tables;
mod vectors;
