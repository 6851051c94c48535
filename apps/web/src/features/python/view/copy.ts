/** Browsers lend the clipboard to secure pages alone: elsewhere the old command is tried. Returns whether it was copied. */
export async function copyText(text: string): Promise<boolean> {
  const clipboard = navigator.clipboard as Clipboard | undefined
  try {
    if (!clipboard) return copyByHand(text)
    await clipboard.writeText(text)
    return true
  } catch (cause) {
    console.warn('The clipboard is not lent to this page.', cause)
    return copyByHand(text)
  }
}

function copyByHand(text: string): boolean {
  const field = document.createElement('textarea')
  field.value = text
  document.body.append(field)
  field.select()
  const done = document.execCommand('copy')
  field.remove()
  return done
}
