import { readForm, readFormText, type LoadedForm } from '../schema/form.ts'
import type { Topic } from '../schema/formTypes.ts'
import { named, once, type Folder } from './folder.ts'

/** Questionnaires, in the order in which they are filled in. */
export function questionnairesIn(content: Folder) {
  const loaded = (folder: string): LoadedForm => ({
    form: named(folder, readForm(content.json(folder, 'form.json'))),
    text: content.translated(folder, readFormText),
  })
  return {
    forms: once(() => content.foldersWith('questionnaires/*/form.json').map(loaded)),
    /** Path of the picture above what is asked about a topic. */
    pictureOfTopic: (topic: Topic) => content.path('questionnaires/pictures', `${topic}.svg`),
  }
}
