import { writeScene, type Project, type Scene } from '@botgarten/programs'

/** Lets the child choose a file; null where none is chosen. */
export function pickFile(accept: string): Promise<File | null> {
  const input = document.createElement('input')
  input.type = 'file'
  input.accept = accept
  return new Promise((done) => {
    input.addEventListener('change', () => done(input.files?.[0] ?? null))
    input.addEventListener('cancel', () => done(null))
    input.click()
  })
}

/** Hands the scene out as a file, through the browser's own download. */
export function saveScene(scene: Scene, pictures: Project['assets'], name: string): void {
  const blob = new Blob([writeScene(scene, pictures)], { type: 'application/json' })
  const address = URL.createObjectURL(blob)
  const link = document.createElement('a')
  link.href = address
  link.download = `${name}.json`
  link.click()
  setTimeout(() => URL.revokeObjectURL(address), 1000)
}
