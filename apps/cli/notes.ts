let notes = ''

/** Says a sentence beside the answer, on standard error. */
export function note(sentence: string): void {
  notes += `botgarten: ${sentence}\n`
}

/** What has been said so far; nothing of it is said twice. */
export function takeNotes(): string {
  const taken = notes
  notes = ''
  return taken
}
