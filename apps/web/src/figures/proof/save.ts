// What comes when a notebook is asked for: its words in every language, and the file.
import { notebookOf, type Proof } from '@botgarten/learning/proof'
import { handOut } from '#storage/handout.ts'
import { language } from '#words/language.svelte.ts'
import { fetchInAll, wordsIn } from '#words/message.ts'

/** A notebook that makes a number again, with its texts in every language, the one of now first. */
export async function saveNotebook(proof: Proof, name: string): Promise<void> {
  await fetchInAll('notebook')
  const locales = [language.locale, ...language.all.filter((one) => one !== language.locale)]
  const facts = { shown: String(proof.number), before: proof.before }
  const text = (part: string) =>
    locales.map((locale) => wordsIn(locale)(`notebook.${proof.method}.${part}`, facts)).join('\n\n')
  handOut(name, notebookOf(proof, text), 'ipynb')
}
