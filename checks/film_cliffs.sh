# Films are fast from both sides, and created in a bounded time: methods and times of 98 films. [--tolerance X, 2e-3]
study film_cliffs "$@"
