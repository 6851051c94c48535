/** Opens a file that is let go anywhere on the page; what takes files itself has the first say. Returns how to end it. */
export function takeDrops(onfile: (file: File) => void, words: () => string): () => void {
  const { dataset } = document.body
  const hover = (event: DragEvent) => {
    if (!event.dataTransfer?.types.includes('Files')) return
    event.preventDefault()
    dataset['drop'] = words()
  }
  const leave = ({ relatedTarget }: DragEvent) => {
    if (!relatedTarget) delete dataset['drop']
  }
  const drop = (event: DragEvent) => {
    delete dataset['drop']
    const file = event.dataTransfer?.files[0]
    if (event.defaultPrevented || !file) return
    event.preventDefault()
    onfile(file)
  }
  addEventListener('dragover', hover)
  addEventListener('dragleave', leave)
  addEventListener('drop', drop)
  return () => {
    removeEventListener('dragover', hover)
    removeEventListener('dragleave', leave)
    removeEventListener('drop', drop)
  }
}
