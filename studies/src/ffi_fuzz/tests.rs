//! The contract over a kept corpus of arbitrary bytes, and over random ones.

use super::{TARGETS, run};
use crate::shared::directions::rng;
use rand::Rng;
use std::fs;
use std::path::{Path, PathBuf};

/// Random inputs of each target, beside the corpus.
const RANDOM: [(&str, usize); 5] = [
    ("batch", 300),
    ("create_bsdf", 300),
    ("create_film", 100),
    ("evaluate", 3000),
    ("load_film", 3000),
];

fn corpus(target: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus");
    let files = fs::read_dir(folder.join(target)).unwrap();
    let mut files: Vec<PathBuf> = files.map(|file| file.unwrap().path()).collect();
    files.sort();
    assert!(!files.is_empty(), "no corpus for {target}");
    files
}

fn replay(target: &str) {
    for file in corpus(target) {
        eprintln!("{}", file.display());
        run(target, &fs::read(&file).unwrap());
    }
    let rng = &mut rng(6);
    let (_, count) = RANDOM.iter().find(|(name, _)| *name == target).unwrap();
    for number in 0..*count {
        eprintln!("random input {number}");
        let mut data = vec![0; 1 + number % 512];
        rng.fill_bytes(&mut data);
        run(target, &data);
    }
}

#[test]
fn batches_keep_the_contract() {
    replay("batch");
}

#[test]
fn creation_of_bsdfs_keeps_the_contract() {
    replay("create_bsdf");
}

#[test]
fn creation_of_films_keeps_the_contract() {
    replay("create_film");
}

#[test]
fn evaluation_keeps_the_contract() {
    replay("evaluate");
}

#[test]
fn loading_of_films_keeps_the_contract() {
    replay("load_film");
}

/// After a change of what is saved the corpus would be refused unread. `PELLICLE_RENEW=1 cargo test -p pellicle-studies
/// ffi_fuzz` writes these films anew.
#[test]
fn the_corpus_has_films_that_load() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus/load_film");
    for (name, description) in super::load_film::seeds() {
        let file = folder.join(name);
        if std::env::var_os("PELLICLE_RENEW").is_some() {
            fs::create_dir_all(&folder).unwrap();
            fs::write(&file, super::load_film::input_of(&description)).unwrap();
        }
        let data = fs::read(&file).unwrap();
        assert!(data.len() <= 4096, "{name} is too long for the fuzzer");
        let block = super::load_film::block(&data);
        pellicle::Film::from_bytes(&block).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}

#[test]
fn every_target_has_a_corpus_and_a_fuzzer() {
    for (target, _) in TARGETS {
        assert!(RANDOM.iter().any(|(name, _)| *name == target));
        assert!(!corpus(target).is_empty());
    }
}
