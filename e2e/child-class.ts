import { expect } from '@playwright/test'
import type { Child } from './child.ts'
import { opensFromHome } from './navigation.ts'

/** A child of a class: on its way in, and in it. */
export class Pupil {
  readonly child: Child
  readonly #code: string

  /** @param class with its code as it is typed */
  constructor(child: Child, { code }: { readonly code: string }) {
    this.child = child
    this.#code = code
  }

  get #page() {
    return this.child.page
  }

  get nickname() {
    return this.#page.locator('#nickname')
  }

  /** Types a code on the page of the class. @param code null: nothing is typed */
  async opens(code: string | null = this.#code) {
    await opensFromHome(this.child, 'home.joinClass')
    await expect(this.child.words('class.joinTitle')).toBeVisible()
    for (const word of code?.split(' ') ?? []) await this.#page.keyboard.type(`${word} `)
  }

  async opensByLink() {
    // By address: a class's link or QR code leads here.
    await this.#page.goto(`/join#${this.#code.replaceAll(' ', '-')}`)
    await expect(this.nickname).toBeFocused()
  }

  /** Joins as somebody new. @returns the three pictures by their names on the page */
  async joins(nickname: string): Promise<string[]> {
    await this.nickname.fill(nickname)
    await this.child.presses('class.join')
    await expect(this.child.words('class.helloPictures', { nickname })).toBeFocused()
    return this.#page.getByRole('listitem').locator('b').allInnerTexts()
  }

  /** Goes on to the cards. */
  async remembers() {
    await this.child.presses('class.remembered')
    await this.seesMe()
  }

  /** Says that it was here before. */
  async returns(nickname: string) {
    await this.child.presses('class.wasThere')
    await this.nickname.fill(nickname)
    await this.child.presses('class.next')
  }

  /** Taps pictures by their names on the page. */
  async taps(...pictures: readonly string[]) {
    for (const name of pictures) await this.#page.getByRole('button', { name, exact: true }).click()
  }

  async isRefused() {
    await expect(this.#page.getByRole('alert').locator('p')).toBeVisible()
  }

  /** The button of who sits here. */
  get me() {
    return this.#page.locator('.person > .button').first()
  }

  async seesMe() {
    await expect(this.me).toBeVisible()
  }

  async opensMenu() {
    await this.me.click()
    await expect(this.child.button('class.leave')).toBeVisible()
  }

  async leaves() {
    await this.opensMenu()
    await this.child.presses('class.leave')
    const question = this.#page.getByRole('dialog')
    await expect(question).toContainText(this.child.word('class.leaveText'))
    await question.getByRole('button', { name: this.child.word('class.leave'), exact: true }).click()
    await expect(this.child.words('class.joinTitle')).toBeVisible()
  }

  /** Where the lab says that the work is: `chipClass`, `chipHere` … */
  chip(state: string) {
    return this.child.button(`class.${state}`)
  }
}
