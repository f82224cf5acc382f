//! The validated values of a model's parameters.

use super::info::{ModelInfo, ParamKind};
use crate::film::Film;
use crate::num::{Real, Rgb, Vec3};
use std::sync::Arc;

/// The least and the greatest value of each parameter, over its own value and its varying range.
pub struct Bounds {
    /// The least value of every component. Choices and film are those of the description.
    pub least: Values<f32>,
    /// The greatest value of every component. Choices and film are those of the description.
    pub greatest: Values<f32>,
}

/// The validated values of a model's parameters, indexed as [`ModelInfo::params`], and the film.
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

    /// Sets the numbers of a parameter. All three components of a scalar are equal.
    pub fn set_numbers(&mut self, param: usize, numbers: [T; 3]) {
        self.numbers[param] = numbers;
    }

    /// Sets the choice of a parameter.
    pub fn set_choice(&mut self, param: usize, choice: usize) {
        self.choices[param] = choice;
    }

    /// Declares that calls may give a parameter; its value here is the default.
    pub fn set_varying(&mut self, param: usize) {
        self.varies[param] = true;
    }

    /// Sets the film.
    pub fn set_film(&mut self, film: Option<Arc<Film>>) {
        self.film = film;
    }

    /// The value of a parameter with one component.
    pub fn number(&self, param: usize) -> T {
        self.numbers[param][0]
    }

    /// The value of a parameter with three components.
    pub fn rgb(&self, param: usize) -> Rgb<T> {
        self.numbers[param]
    }

    /// The index of the choice made for a parameter.
    pub fn choice(&self, param: usize) -> usize {
        self.choices[param]
    }

    /// Whether calls may give a parameter, so that code cannot be specialised for its value.
    pub fn varies(&self, param: usize) -> bool {
        self.varies[param]
    }

    /// The film. After validation it is there for every model that needs one.
    pub fn film(&self) -> Option<&Arc<Film>> {
        self.film.as_ref()
    }
}
