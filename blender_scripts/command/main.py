import subprocess, sys
print(sys.argv)
i = sys.argv.index("blender")
sys.exit(subprocess.call(["blender", *sys.argv[i+1:]]))
