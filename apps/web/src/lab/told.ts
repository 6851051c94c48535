const frame = () => new Promise<void>((done) => requestAnimationFrame(() => setTimeout(done, 0)))

/**
 * Resolves when Blockly has told of all that a hand has done so far. It tells a frame and a task later, and a list
 * that closes a line when it is told has that told in turn. A step that is taken back before is not known whole, and
 * its late rest would throw away what could come again.
 */
export async function told(): Promise<void> {
  await frame()
  await frame()
}
