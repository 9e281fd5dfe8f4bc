// The entry of every test executable; it lives here and not in gtest_main so that it carries our precompiled header.
#include <gtest/gtest.h>

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
