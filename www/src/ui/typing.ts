/** Whether a key writes somewhere: in a field, or in an editor, which a shadow root may hold. */
export function isTyping(event: Event): boolean {
  const [target] = event.composedPath()
  return (
    target instanceof HTMLElement &&
    (target.matches('input:not([type=range], [type=checkbox], [type=radio]), textarea') || target.isContentEditable)
  )
}
