"""Predictions: a question, what the reader expects, and only then the answer."""

from .asking import Prediction, predict, predict_again, tally
