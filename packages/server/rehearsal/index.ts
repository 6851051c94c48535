// Plays lessons on servers in processes of their own: for rehearsals, and for what is measured.
export { Client } from './client.ts'
export { playLesson, type Figures } from './lesson.ts'
export { startNode, type ServingNode } from './node.ts'
export { projectOfLesson } from './projects.ts'
export { ownSchema } from './schema.ts'
export { isGreen, limits, rehearse } from './rehearse.ts'
