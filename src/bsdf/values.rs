//! The validated values of a model's parameters.

use super::info::{ModelInfo, ParamKind};
use crate::film::Film;
use crate::num::{Real, Rgb, Vec3};
use std::sync::Arc;

/// What each parameter can be: its own value and its varying range together.
pub struct Bounds {
    /// The least value of every component; choices and film as they are.
    pub least: Values<f32>,
    /// The greatest value of every component.
    pub greatest: Values<f32>,
}

/// One entry per parameter of a model, in the order of [`ModelInfo::params`], and the film.
#[derive(Clone)]
pub struct Values<T> {
    numbers: Vec<[T; 3]>,
    choices: Vec<usize>,
    varies: Vec<bool>,
    film: Option<Arc<Film>>,
}

impl<T: Real> Values<T> {
    /// Every parameter at its default.
    pub fn defaults(info: &ModelInfo) -> Self {
        let numbers = info.params.iter().map(|param| match param.kind {
            ParamKind::Number { default, .. } => [T::new(f64::from(default)); 3],
            ParamKind::Direction { .. } => {
                Vec3::new(T::new(0.0), T::new(0.0), T::new(1.0)).to_array()
            }
            ParamKind::Choice { .. } => [T::new(0.0); 3],
        });
        Self {
            numbers: numbers.collect(),
            choices: vec![0; info.params.len()],
            varies: vec![false; info.params.len()],
            film: None,
        }
    }

    /// Sets the numbers of a parameter; a scalar is in all three places.
    pub fn set_numbers(&mut self, param: usize, numbers: [T; 3]) {
        self.numbers[param] = numbers;
    }

    /// Sets the choice of a parameter.
    pub fn set_choice(&mut self, param: usize, choice: usize) {
        self.choices[param] = choice;
    }

    /// Declares that a parameter is given per call; its value here is what it is otherwise.
    pub fn set_varying(&mut self, param: usize) {
        self.varies[param] = true;
    }

    /// Sets the film.
    pub fn set_film(&mut self, film: Option<Arc<Film>>) {
        self.film = film;
    }

    /// A parameter with one component.
    pub fn number(&self, param: usize) -> T {
        self.numbers[param][0]
    }

    /// A parameter with one component per colour channel.
    pub fn rgb(&self, param: usize) -> Rgb<T> {
        self.numbers[param]
    }

    /// The index of the choice made for a parameter.
    pub fn choice(&self, param: usize) -> usize {
        self.choices[param]
    }

    /// Whether a parameter is given per call: what depends on it cannot be compiled in.
    pub fn varies(&self, param: usize) -> bool {
        self.varies[param]
    }

    /// The film, which a model that needs one has.
    pub fn film(&self) -> Option<&Arc<Film>> {
        self.film.as_ref()
    }
}
