import { notebookOf, type Proof } from '@botgarten/learning/proof'
import { FileError } from './errors.ts'
import { write } from './files.ts'
import { languages, messageOf } from './words.ts'

/** Writes a notebook that makes the number again, with its texts in every language. @throws {FileError} */
export function writeNotebook(path: string, proof: Proof | null): void {
  if (!proof) throw new FileError('file.proofTooLarge', { path })
  const facts = { shown: String(proof.number), before: proof.before }
  const text = (part: string) =>
    languages
      .map((language) => messageOf('notebook', language, `notebook.${proof.method}.${part}`, facts))
      .join('\n\n')
  write(path, notebookOf(proof, text))
}
