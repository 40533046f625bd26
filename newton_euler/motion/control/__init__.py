"""The control of the error: how a motion is run so that it is as accurate as asked."""
