import content from 'content:questionnaires'
import { columnsOf, type Column } from '@botgarten/answers'
import { moments, type FormItem, type FormText, type LoadedForm } from '@botgarten/content/questionnaires'
import type { AskedQuestion } from '@botgarten/content/catalogue'
import { language } from '#words/language.svelte.ts'

const questions = content.asked.map(({ question }) => question)

/** The product's forms and those changed on this device, as they follow each other. */
export const allForms = (own: readonly LoadedForm[]): readonly LoadedForm[] =>
  moments.flatMap((moment) => [...content.forms, ...own].filter(({ form }) => form.moment === moment))

export const isOurs = (id: string): boolean => content.forms.some(({ form }) => form.id === id)

/** The words of a form in the language of now, in English, or in whatever it has. */
export const textOf = ({ text }: LoadedForm): FormText =>
  text[language.locale] ?? text['en'] ?? Object.values(text)[0]!

/** Some words of a form; empty where it has none. */
export const wordOf = (text: FormText, section: string, name: string): string => {
  const words = Object.hasOwn(text.words, section) ? text.words[section] : undefined
  return words && Object.hasOwn(words, name) ? words[name]! : ''
}

export const columnsIn = ({ form }: LoadedForm): readonly Column[] => columnsOf(form, questions)

export const askedOf = (id: string): AskedQuestion =>
  content.asked.find(({ question }) => question.id === id)!

/** May this form be asked here? One from a file may name a question that this version does not have. */
export const isKnown = ({ form }: LoadedForm): boolean =>
  form.items.every((item) => item.kind !== 'robot' || askedOf(item.question) !== undefined)

const askedText = (id: string) => {
  const { text } = askedOf(id)
  return text[language.locale] ?? text['en']!
}

/** How something is asked: to children who have just learned to read, beside the picture of its topic, or alone. */
export type Manner = 'young' | 'here' | 'question'

export function questionOf(item: FormItem, text: FormText, manner: Manner): string {
  if (item.kind === 'robot') return askedText(item.question).question
  return wordOf(text, item.id, manner) || wordOf(text, item.id, 'question')
}

/** The words of an option of an item. */
export function optionOf(item: FormItem, text: FormText, option: string): string {
  if (item.kind === 'robot') return askedText(item.question).choices[option] ?? option
  return wordOf(text, item.kind === 'scale' ? item.scale : item.id, option)
}

export const optionsOf = (item: FormItem): readonly string[] =>
  item.kind === 'scale'
    ? ['1', '2', '3', '4', '5']
    : item.kind === 'choice'
      ? item.choices
      : item.kind === 'robot'
        ? askedOf(item.question).question.choices
        : []

export const pictureOf = content.pictures
