type KeyPress = Pick<KeyboardEvent, 'key' | 'ctrlKey' | 'metaKey' | 'shiftKey' | 'altKey'>

/** Ctrl or Cmd with Z takes back; with Shift and Z, or Y, it goes on again. Null for other keys. */
export function undoKey({ key, ctrlKey, metaKey, shiftKey, altKey }: KeyPress): 'undo' | 'redo' | null {
  if (ctrlKey === metaKey || altKey) return null
  if (key.toLowerCase() === 'y' && !shiftKey) return 'redo'
  if (key.toLowerCase() !== 'z') return null
  return shiftKey ? 'redo' : 'undo'
}

/** In a text field these keys take back letters, in a dialog nothing. */
export const isTyping = (target: EventTarget | null): boolean =>
  target instanceof Element && target.closest('input, textarea, dialog') !== null
