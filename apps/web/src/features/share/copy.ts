/**
 * Copies what stands in a field. Browsers lend the clipboard to secure pages alone: elsewhere the field is chosen and the
 * old command tried.
 * @returns whether it was copied; if not, what is to be copied is chosen
 */
export async function copyFrom(field: HTMLInputElement): Promise<boolean> {
  field.focus()
  field.select()
  try {
    const clipboard = navigator.clipboard as Clipboard | undefined
    if (clipboard) await clipboard.writeText(field.value)
    return clipboard ? true : document.execCommand('copy')
  } catch (cause) {
    console.warn('The clipboard is not lent to this page.', cause)
    return document.execCommand('copy')
  }
}
