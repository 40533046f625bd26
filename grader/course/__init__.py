"""A course: its folder, its students and the files that they hand in.

identity    who a student is, and what a course is called
files       reading and writing files, also those that are not trusted
folder      the course folder: paths, secret, gradebook, each student's numbers
creation    makes a new course folder
due         the due date of an assignment; exam: with a window of time and one attempt
roster      reads the lists of students that registrars and learning platforms export
take_in     puts the work in a zip archive into the course, without nbgrader's exchange
"""

from .files import load_json, read_json, write_json, write_notebook
from .folder import Course
from .identity import CourseError, check_id, seen_as
from .roster import Roster, read_roster
from .take_in import take_in
