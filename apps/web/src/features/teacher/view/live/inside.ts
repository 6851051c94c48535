import { withWords } from '#words/message.ts'

/** What draws programs and networks: it comes when a teacher looks inside for the first time. */
export const loadInside = () => withWords(import('../../lazy.ts'), ['network', 'materials'])
