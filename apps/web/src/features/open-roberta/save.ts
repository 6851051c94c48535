import { handOut } from '#storage/handout.ts'
import { fileFrom, fileInSteps } from '@botgarten/programs/open-roberta'
import type { Outgoing } from './outgoing.ts'

/** Hands a program out as a file; `inSteps`: with its network in Open Roberta's own blocks. */
export const save = ({ project, robot }: Outgoing, inSteps = false): void =>
  handOut(project.name, inSteps ? fileInSteps(project, robot) : fileFrom(project, robot), 'xml')
