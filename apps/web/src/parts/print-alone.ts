/**
 * While an element is on the page, the printer gets it alone (app.css). Its ancestors are marked as well: Firefox before 121 has
 * no `:has` to find them. An attachment; `data-print-alone` marks the element itself.
 */
export function printAlone(element: HTMLElement): () => void {
  const holding: HTMLElement[] = []
  for (let one = element.parentElement; one; one = one.parentElement) holding.push(one)
  element.dataset['printAlone'] = ''
  for (const one of holding) one.dataset['printHolds'] = ''
  return () => {
    for (const one of holding) delete one.dataset['printHolds']
  }
}
