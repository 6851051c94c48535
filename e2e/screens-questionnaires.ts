import { Asker } from './child-questionnaires.ts'
import type { Child } from './child.ts'
import type { Screen } from './screens.ts'

/** A device on which a form is asked. */
async function asking(child: Child, grade: number): Promise<Asker> {
  const asker = new Asker(child)
  await asker.comes()
  await asker.asks('after', grade)
  return asker
}

async function takes(child: Child, asker: Asker, form: string) {
  await asker.takesFile(
    form,
    5,
    Array.from({ length: 22 }, (_, n) => n),
  )
  await child.words('form.takenAnswers', { count: 22 }).waitFor()
}

export const questionnaireScreens: readonly Screen[] = [
  {
    name: 'questionnaires',
    show: (child) => new Asker(child).comes(),
  },
  {
    name: 'question-code',
    async show(child) {
      const asker = await asking(child, 5)
      await asker.choosesCode('blue-tit', 427)
    },
  },
  {
    name: 'question-young',
    async show(child) {
      const asker = await asking(child, 3)
      await child.presses('form.codeForgot')
      await asker.answers('after', asker.form('after').form.items[0]!, '4', true)
    },
  },
  {
    name: 'question-older',
    async show(child) {
      const asker = await asking(child, 5)
      await child.presses('form.codeForgot')
      await asker.answers('after', asker.form('after').form.items[0]!, '4', false)
    },
  },
  {
    name: 'question-bo',
    async show(child) {
      await asking(child, 5)
      await child.presses('form.codeForgot')
      for (let screen = 1; screen < 6; screen += 1) await child.presses('form.next')
    },
  },
  {
    name: 'question-results',
    async show(child) {
      const asker = new Asker(child)
      await asker.comes()
      await takes(child, asker, 'before')
      await child.page.goto('/questionnaires')
      await takes(child, asker, 'after')
      await asker.opens('after', 'form.results')
    },
  },
  {
    name: 'question-typing',
    async show(child) {
      const asker = new Asker(child)
      await asker.comes()
      await asker.opens('after', 'form.typeIn')
    },
  },
  {
    name: 'question-paper',
    async show(child) {
      const asker = new Asker(child)
      await asker.comes()
      await asker.opens('after', 'form.paper')
    },
  },
]
