<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en">
<context>
    <name>aerostat::viewer::MainWindow</name>
    <message numerus="yes">
        <source>%n sample(s) a pixel</source>
        <translation>
            <numerusform>%n sample a pixel</numerusform>
            <numerusform>%n samples a pixel</numerusform>
        </translation>
    </message>
</context>
</TS>
