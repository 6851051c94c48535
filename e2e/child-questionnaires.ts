import { expect, type Locator } from '@playwright/test'
import { content } from '@botgarten/content/files'
import type { FormItem } from '@botgarten/content/questionnaires'
import type { Child } from './child.ts'
import { opensFromHome } from './navigation.ts'

/** What a teacher and children do with questionnaires on one device. */
export class Asker {
  readonly child: Child
  readonly #by: 'click' | 'tap'

  constructor(child: Child, by: 'click' | 'tap' = 'click') {
    this.child = child
    this.#by = by
  }

  #press = (thing: Locator) => thing[this.#by]()
  presses = (key: string) => this.#press(this.child.button(key).first())

  get #page() {
    return this.child.page
  }

  form = (id: string) => content.forms.find(({ form }) => form.id === id)!

  #text(id: string) {
    return this.form(id).text[this.child.language]!
  }

  #card(id: string) {
    return this.#page.getByRole('article').filter({
      has: this.#page.getByRole('heading', { name: this.#text(id).title, exact: true }),
    })
  }

  /** From all materials on to all questionnaires. */
  async comes() {
    await opensFromHome(this.child, 'home.materials')
    await this.#page.getByRole('link', { name: this.child.word('materials.questionnaires') }).click()
    await expect(this.#card('after')).toBeVisible()
  }

  async opens(id: string, key: string) {
    await this.#card(id)
      .getByRole('link', { name: this.child.word(key), exact: true })
      .click()
  }

  async asks(id: string, grade: number) {
    await this.#page.getByRole('combobox').selectOption(String(grade))
    await this.#card(id)
      .getByRole('button', { name: this.child.word('form.ask'), exact: true })
      .click()
    await expect(this.child.words('form.codeTitle')).toBeVisible()
  }

  async choosesCode(bird: string, number: number) {
    await this.presses(`form.bird.${bird}`)
    await this.#page.getByLabel(this.child.word('form.number'), { exact: true }).fill(String(number))
  }

  async begins() {
    await this.presses('form.begin')
  }

  /** The words of an option as they are tapped. */
  #option(form: string, item: FormItem, option: string, young: boolean): string {
    const { words } = this.#text(form)
    if (item.kind === 'robot')
      return content.itemTexts(this.child.language).questions[item.question]!.choices[option]!
    const word = words[item.kind === 'scale' ? item.scale : item.id]![option]!
    return item.kind === 'scale' && !young ? `${option}: ${word}` : word
  }

  #asked(form: string, item: FormItem, young: boolean): string {
    if (item.kind === 'robot')
      return content.itemTexts(this.child.language).questions[item.question]!.question
    const words = this.#text(form).words[item.id]!
    const here = item.kind === 'scale' ? words['here'] : undefined
    return (young ? words['young'] : here) ?? words['question']!
  }

  /** Answers one item of the screen. */
  async answers(form: string, item: FormItem, value: string, young: boolean) {
    const asked = this.#asked(form, item, young)
    if (item.kind === 'text') return this.#page.getByRole('textbox', { name: asked, exact: true }).fill(value)
    const name = this.#option(form, item, value, young)
    const group = this.#page.getByRole('group', { name: asked, exact: true })
    await this.#press(group.getByRole('button', { name, exact: true }))
    await expect(group.getByRole('button', { name, exact: true })).toHaveAttribute('aria-pressed', 'true')
  }

  /** Takes a file with what other children answered elsewhere: the n-th of each. */
  async takesFile(form: string, grade: number, children: readonly number[]) {
    const { items } = this.form(form).form
    const answers = children.map((n) => ({
      ...{
        id: `${form.length}${n}`.padStart(32, '0'),
        form,
        grade,
        code: `swan-${100 + n}`,
        day: '2026-11-26',
      },
      values: Object.fromEntries(items.map((item) => [item.id, nth(n)(item)])),
    }))
    const buffer = Buffer.from(JSON.stringify({ botgarten: 'answers', version: 1, answers }))
    const file = { name: 'answers.json', mimeType: 'application/json', buffer }
    await this.#page.locator('input[type=file]').setInputFiles(file)
  }

  /** Answers a whole form, screen by screen, to its thanks. */
  async fillsIn(form: string, young: boolean, valueOf: (item: FormItem) => string) {
    const { items, screens } = this.form(form).form
    const shown = young ? items.map(({ id }) => [id]) : screens
    for (const [at, screen] of shown.entries()) {
      for (const id of screen) {
        const item = items.find((one) => one.id === id)!
        await this.answers(form, item, valueOf(item), young)
      }
      await this.presses(at === shown.length - 1 ? 'form.done' : 'form.next')
    }
    await expect(this.child.words('form.thanks')).toBeVisible()
  }
}

/** What the n-th child answers: no two alike, and the robot's questions right from the second child on. */
export const nth =
  (n: number) =>
  (item: FormItem): string => {
    if (item.kind === 'scale') return String((n % 5) + 1)
    if (item.kind === 'choice') return item.choices[n % item.choices.length]!
    if (item.kind === 'text') return `Bo ${'🌱'.repeat(n + 1)}`
    const question = content.questions.find(({ id }) => id === item.question)!
    return n === 0 ? question.choices.find((one) => one !== question.answer)! : question.answer
  }
