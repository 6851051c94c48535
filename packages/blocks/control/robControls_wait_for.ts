import { waitingBlock } from '../parts/waits.ts'

export const robControls_wait_for = waitingBlock('robControls_wait_for', 'expert')
