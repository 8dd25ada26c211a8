# `fovea test`
