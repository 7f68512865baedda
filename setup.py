"""What setup.cfg cannot say, as it takes no glob: every file of bin/ is a command, every file below man/ a manual page."""
import glob
import os

import setuptools

os.chdir(os.path.dirname(os.path.abspath(__file__)))
PAGES = {}
for path in sorted(glob.glob("man/**/rt*.[17]", recursive=True)):
    PAGES.setdefault("share/" + os.path.dirname(path), []).append(path)

setuptools.setup(scripts=sorted(path for path in glob.glob("bin/rt*") if os.path.basename(path).isalnum()),
                 data_files=sorted(PAGES.items()))
