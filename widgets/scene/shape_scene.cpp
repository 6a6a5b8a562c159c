#include "widgets/scene/shape_scene.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <glm/trigonometric.hpp>

#include <cmath>
#include <utility>

namespace halfspace {

ShapeScene::ShapeScene(LabelPainter labels) : m_labels(m_actors.renderer(), std::move(labels)) {}

void ShapeScene::show(const ShapeList &list) {
  m_list = list;
  m_actors.show(list);
  m_labels.show(list.layer(Layer::Labels), list.view.size);
  showCamera();
  showStrip(0, list.view.size.height);
}

void ShapeScene::showCamera() {
  const Camera &camera = m_list.view.camera;
  vtkCamera *vtk = m_actors.renderer()->GetActiveCamera();
  const Place eye = camera.eye();
  const Place up = camera.up();
  vtk->SetPosition(eye.x, eye.y, eye.z);
  vtk->SetFocalPoint(camera.target.x, camera.target.y, camera.target.z);
  vtk->SetViewUp(up.x, up.y, up.z);
  vtk->SetParallelProjection(camera.orthographic);
  vtk->SetClippingRange(m_list.depths.nearest, m_list.depths.farthest);
}

void ShapeScene::showStrip(int top, int height) {
  const View &view = m_list.view;
  const double part = static_cast<double>(height) / view.size.height;
  const double middle = top + height / 2.0;
  const int below = view.size.height - top - height;
  vtkCamera *vtk = m_actors.renderer()->GetActiveCamera();
  vtk->SetViewAngle(glm::degrees(2 * std::atan(std::tan(Camera::viewAngle / 2) * part)));
  vtk->SetParallelScale(view.camera.height / 2 * part);
  vtk->SetWindowCenter(0, (view.size.height / 2.0 - middle) / (height / 2.0));
  m_labels.lowerBy(below);
  m_actors.showBackground(m_list.background, static_cast<double>(below) / view.size.height,
                          1 - static_cast<double>(top) / view.size.height);
}

} // namespace halfspace
