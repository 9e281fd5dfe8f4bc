// A program of one room of the server: linking it is the test (tests/CMakeLists.txt).
int main() {}
