// Links all public headers into one program; see CMakeLists.txt.
int main() {}
