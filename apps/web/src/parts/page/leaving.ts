/**
 * Has the focus moved from inside `place` to an element outside of it? Pressing plain words moves the focus to the nearest
 * element around them that can have it, which may contain `place`: that does not count.
 * @param target the element that has the focus now (`relatedTarget` of a `focusout`)
 */
export const hasLeft = (place: HTMLElement, target: EventTarget | null): boolean =>
  target instanceof Node && !place.contains(target) && !target.contains(place)
