import type { FormItem, LoadedForm } from '@botgarten/content/questionnaires'
import type { Values } from './sheets.svelte.ts'

/** Most letters of a sentence of one's own. */
export const mostLetters = 500

/** From this grade on there is one topic a screen; before, one question. */
const firstOlder = 5
export const isYoung = (grade: number): boolean => grade < firstOlder

/** What one child is answering: nothing of it is kept before the end. */
export class Filling {
  readonly screens: readonly (readonly FormItem[])[]
  values = $state.raw<Values>({})
  at = $state(0)

  constructor({ form }: LoadedForm, young: boolean) {
    const itemOf = (id: string) => form.items.find((item) => item.id === id)!
    this.screens = young ? form.items.map((item) => [item]) : form.screens.map((ids) => ids.map(itemOf))
  }

  get screen(): readonly FormItem[] {
    return this.screens[this.at]!
  }
  get isLast(): boolean {
    return this.at === this.screens.length - 1
  }

  /** Answers an item; an empty sentence is none. */
  answer(item: string, value: string): void {
    const rest = Object.entries(this.values).filter(([id]) => id !== item)
    const text = value.slice(0, mostLetters)
    this.values = Object.fromEntries(text.trim() === '' ? rest : [...rest, [item, text]])
  }

  /** Leaves out what stands on this screen. */
  skip(): void {
    for (const { id } of this.screen) this.answer(id, '')
  }
}
