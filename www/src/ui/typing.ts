/** Whether keys write there. */
export const isTyping = (target: EventTarget | undefined | null): boolean =>
  target instanceof HTMLElement &&
  (target.matches('input:not([type=range], [type=checkbox], [type=radio]), textarea') || target.isContentEditable)
