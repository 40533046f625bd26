"""The figures of the chapters, one module a chapter. A function shows a figure in the notebook; it
takes the mechanism that the notebook builds, so that a change there is a change in the picture.
"""
