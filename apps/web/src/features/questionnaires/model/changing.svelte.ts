import type { FormItem, FormText, LoadedForm } from '@botgarten/content/questionnaires'
import { isOurs } from './forms.ts'

const mostItems = 40

/** A form while a teacher changes it: questions are changed, left out, or added at the end. */
export class Changing {
  readonly #loaded: LoadedForm
  readonly #language: string
  title = $state('')
  /** By item, whether it is asked. */
  asked = $state<{ [item: string]: boolean }>({})
  /** By item, its question. */
  questions = $state<{ [item: string]: string }>({})
  added = $state.raw<readonly FormItem[]>([])

  constructor(loaded: LoadedForm, language: string, text: FormText) {
    this.#loaded = loaded
    this.#language = language
    this.title = text.title
    for (const { id } of loaded.form.items) {
      this.asked[id] = true
      this.questions[id] = text.words[id]?.['question'] ?? ''
    }
  }

  get items(): readonly FormItem[] {
    return [...this.#loaded.form.items, ...this.added]
  }

  get isFull(): boolean {
    return this.items.length >= mostItems
  }

  /** Adds a question of one's own: 1 to 5 from no to yes, or a sentence. */
  add(kind: 'scale' | 'text'): void {
    const taken = this.items.map(({ id }) => id)
    let number = 1
    while (taken.includes(`own-${number}`)) number += 1
    const id = `own-${number}`
    this.added = [...this.added, kind === 'scale' ? { id, kind, scale: 'own-scale' } : { id, kind }]
    this.asked[id] = true
    this.questions[id] = ''
  }

  get isReady(): boolean {
    const asked = this.items.filter(({ id }) => this.asked[id])
    const worded = asked.every(({ id, kind }) => kind === 'robot' || this.questions[id]!.trim() !== '')
    return asked.length > 0 && worded && this.title.trim() !== ''
  }

  /**
   * The changed form in the language of now: words of others would no longer be its own.
   * @param id a new name, for one of the product's forms
   * @param ownScale what the steps of an added scale are called
   */
  made(id: string, ownScale: readonly string[]): LoadedForm {
    const { form, text } = this.#loaded
    const items = this.items.filter((item) => this.asked[item.id])
    const there = items.map((item) => item.id)
    const kept = form.screens.map((ids) => ids.filter((one) => there.includes(one)))
    const own = this.added.filter((item) => there.includes(item.id)).map((item) => [item.id])
    const before = text[this.#language] ?? text['en'] ?? Object.values(text)[0]!
    return {
      form: {
        ...{ id: isOurs(form.id) ? id : form.id, moment: form.moment, items },
        screens: [...kept.filter((ids) => ids.length > 0), ...own],
      },
      text: { [this.#language]: this.#wordsOf(before, items, ownScale) },
    }
  }

  #wordsOf(before: FormText, items: readonly FormItem[], ownScale: readonly string[]): FormText {
    const changed = items.map(({ id }) => {
      const words = before.words[id] ?? {}
      const question = this.questions[id]!.trim().slice(0, 400)
      // A question in other words is asked so everywhere.
      return [id, words['question'] === question ? words : { ...rest(words), question }] as const
    })
    const scale = Object.fromEntries(ownScale.map((step, at) => [String(at + 1), step]))
    const words = { ...before.words, 'own-scale': scale, ...Object.fromEntries(changed) }
    return { ...before, title: this.title.trim().slice(0, 100), words }
  }
}

const rest = (words: { readonly [name: string]: string }) =>
  Object.fromEntries(Object.entries(words).filter(([name]) => !['question', 'here', 'young'].includes(name)))
