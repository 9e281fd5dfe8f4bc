// A stream, path, streak or time surface as a filter of a VTK pipeline: wakesurf::vtk. Named as VTK names its
// classes.
#pragma once

#include <vtkPolyDataAlgorithm.h>

#include <memory>
#include <string>

/// The first input is the flow: any data set with three-dimensional cells, or blocks of them, and a velocity.
/// The second, if there is one, is the rake: the points of its first line, or all its points. Without it the
/// rake goes from Point1 to Point2.
/// The filter asks upstream for the time-steps that it needs, one after the other, and holds them in memory,
/// as they are and as float. They are asked for again where the first input or the times change, not where
/// the rake does. Downstream may ask for a time between From and To: a path, streak or time surface is then
/// the one of that time, else the one at its end.
/// The output has the points that `wakesurf surface` writes of the same data, with the arrays s, t, speed,
/// velocity, component, approximated and error. What fails is a vtkErrorMacro with the words of the command
/// line, and leaves the output empty.
class vtkIntegralSurface : public vtkPolyDataAlgorithm {
  public:
    static vtkIntegralSurface* New();
    vtkTypeMacro(vtkIntegralSurface, vtkPolyDataAlgorithm);
    void PrintSelf(ostream& os, vtkIndent indent) override;

    enum KindType { STREAM = 0, PATH = 1, STREAK = 2, TIME = 3 };

    enum AccuracyType { FAST = 0, BALANCED = 1, EXACT = 2 };

    /// The kind of surface, STREAM by default. A time surface wants Sweep.
    vtkSetClampMacro(Kind, int, STREAM, TIME);
    vtkGetMacro(Kind, int);

    /// The accuracy, BALANCED by default.
    vtkSetClampMacro(Accuracy, int, FAST, EXACT);
    vtkGetMacro(Accuracy, int);

    /// The ends of a straight rake, in the data's unit of length.
    vtkSetVector3Macro(Point1, double);
    vtkGetVector3Macro(Point1, double);
    vtkSetVector3Macro(Point2, double);
    vtkGetVector3Macro(Point2, double);

    /// The number of seeds that the rake begins with, 32 by default.
    vtkSetClampMacro(Seeds, int, 2, 100000);
    vtkGetMacro(Seeds, int);

    /// The first release and the end, in the data's unit of time; time runs backward if To is smaller. If
    /// both are the same, the default, they are the first and the last time of the data.
    vtkSetMacro(From, double);
    vtkGetMacro(From, double);
    vtkSetMacro(To, double);
    vtkGetMacro(To, double);

    /// The longest edge allowed; 0, the default, stands for the finest spacing of the data.
    vtkSetMacro(Separation, double);
    vtkGetMacro(Separation, double);

    /// The vector along which the rake is swept to make a time surface.
    vtkSetVector3Macro(Sweep, double);
    vtkGetVector3Macro(Sweep, double);

    /// The name of the velocity; empty, the default: chosen as an import does.
    vtkSetMacro(Velocity, std::string);
    vtkGetMacro(Velocity, std::string);

    /// Connects the rake, polygonal data.
    void SetRakeConnection(vtkAlgorithmOutput* rake) { SetInputConnection(1, rake); }

  protected:
    vtkIntegralSurface();
    ~vtkIntegralSurface() override;

    int FillInputPortInformation(int port, vtkInformation* info) override;
    int RequestInformation(vtkInformation* request,
                           vtkInformationVector** inputs,
                           vtkInformationVector* outputs) override;
    int RequestUpdateExtent(vtkInformation* request,
                            vtkInformationVector** inputs,
                            vtkInformationVector* outputs) override;
    int RequestData(vtkInformation* request,
                    vtkInformationVector** inputs,
                    vtkInformationVector* outputs) override;

  private:
    vtkIntegralSurface(const vtkIntegralSurface&) = delete;
    void operator=(const vtkIntegralSurface&) = delete;

    int Kind = STREAM;
    int Accuracy = BALANCED;
    int Seeds = 32;
    double Point1[3] = {0.0, 0.0, 0.0};
    double Point2[3] = {1.0, 0.0, 0.0};
    double From = 0.0;
    double To = 0.0;
    double Separation = 0.0;
    double Sweep[3] = {0.0, 0.0, 0.0};
    std::string Velocity;

    struct Internals;
    std::unique_ptr<Internals> Internal;
};
