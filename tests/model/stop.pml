/* How a drive stops its motors and mends its link, for any protocol; mcp.pml, legacy.pml and mcb.pml say what is theirs
 * and include this. Packets are whole here: what damages bytes is the framers' business and theirs to be tested for.
 *
 * A run is a row of phases without an end. In each the person acts once (or starts and then stops at any moment), the
 * board is good, disobedient or reset, and the line is
 *   CLEAN | NOISY: up to FAULTS packets fare badly, then clean | MUTE: no answer arrives | DEAD: nothing arrives.
 * The phase is over when the drive has nothing left to do; how it ended is printed, with all that was chosen, and
 * tst_stop_model plays the same to the real machines.
 *
 * Held for in the whole state space (spin -a; cc -DSAFETY pan.c; ./pan, and cc -DNP pan.c; ./pan -l):
 *   a START leaves only if the user has armed after the last Stop, and none while a stop is not confirmed;
 *   no second packet before the answer to the first, but a stop without a link;
 *   "drive idle" is told of no motor that is driven;
 *   a stop ends in that word or in the alarm, for every motor, also those that become known only later;
 *   where the line gets well and the board obeys it ends in that word; and every phase ends. */

#ifndef FAULTS
#define FAULTS 2
#endif
#define ROUNDS 2    /* of STOP and state without success until the alarm; half a second */
#define ATTEMPTS 3  /* to mend the link until it counts as lost */
#define READINGS 2  /* idle ones in a row */

mtype = { JOIN, WHO, GET, STOP, START, NOTICE };       /* what is asked; NOTICE: a board says that it was reset */
mtype = { CLEAN, NOISY, MUTE, DEAD };                  /* the line */
mtype = { NOTHING, ARM, DOSTART, DOSTOP, DOBOTH };     /* the person */
mtype = { DELIVERED, ASKLOST, ANSWERLOST, TWICE, LATE };
mtype = { UP, MENDING, LOST };                         /* the link */
#define REQUESTED 1
#define ACCEPTED 2
#define IDLE 4
#define ALARM 8

chan up = [4] of { mtype, byte };
chan down = [4] of { mtype, byte, byte };

/* the board */
bool drives[MOTORS], joined, fresh, obeys = true;
/* the line */
mtype line = CLEAN, startFate = DELIVERED;
byte faults;
/* the person */
mtype act = NOTHING;
byte subject;
bool latch, wantsStop, wasReset, calm = true;
/* the drive */
mtype link = LOST, waiting = 0; bool identified, armed, startWanted, gaveUp, needsLook;
byte known = 1, attempts, rounds, turn, reads;
bool open, wanted[MOTORS], sent[MOTORS], idle[MOTORS], alarmed[MOTORS];
byte count[MOTORS], told[MOTORS], starts, stops;

#define MOVING(n) (wanted[n] && !idle[n])    /* as far as is known */
#define LAST (MOTORS - 1)
#define EXCLUSIVE (open && (MOVING(0) || MOVING(LAST)))
#define ANYALARM  (open && ((MOVING(0) && alarmed[0]) || (MOVING(LAST) && alarmed[LAST])))
#define ALLALARM  (open && (!MOVING(0) || alarmed[0]) && (!MOVING(LAST) || alarmed[LAST]))
#define STUCK     (ALLALARM && (!MOVING(0) || drives[0]) && (!MOVING(LAST) || drives[LAST]))
#define QUIET     (len(up) + len(down) == 0)

/* What the board does with it, and its answer. That it was reset it says until it is heard, or a blind BEACON came. */
inline board(k, m, fate) {
    answers = false; value = 0;
    if
    :: k == JOIN -> answers = true; value = fresh; joined = true
    :: k != JOIN && (joined || !NEEDS_JOIN) ->
        answers = true;
        if
        :: k == STOP && obeys -> drives[m] = false
        :: k == START -> drives[m] = true
        :: k == GET -> value = drives[0] + 2 * (MOTORS > 1 && drives[LAST])
        :: else -> skip
        fi
    :: else -> skip
    fi;
    if
    :: answers && fate != ANSWERLOST -> down!k,m,value;
        if :: fate == TWICE -> down!k,m,value :: else -> skip fi
    :: else -> skip
    fi
}

/* The line lets a packet through, or not; each choice is printed in the order in which it is made. */
inline transmit(k, m, fate) {
    if
    :: line == DEAD -> fate = ASKLOST
    :: line == MUTE -> fate = ANSWERLOST
    :: k == START && line == NOISY -> fate = startFate
    :: else ->
        if
        :: line == CLEAN || faults == 0 -> fate = DELIVERED
        :: line == NOISY && faults > 0 ->
            if :: fate = ASKLOST :: fate = ANSWERLOST :: fate = TWICE :: fate = LATE :: fate = DELIVERED fi;
            faults--;
            printf("fate %e\n", fate)
        fi
    fi;
    if :: fate == ASKLOST -> skip :: else -> board(k, m, fate) fi
}
inline ask(k, m) {
    assert(waiting == 0 && QUIET);                     /* one in flight */
    transmit(k, m, fate);
    waiting = k; asked = m; expires = (fate != DELIVERED && fate != TWICE)
}

#define EACH(n) i = 0; do :: i < n ->
#define DONE i++ :: else -> i = 0; break od
inline tell(m, word) { told[m] = told[m] | word }
inline forget() { identified = false; known = 1 }
inline disarm() { armed = false; startWanted = false }

/* Asked for again, a stop goes on: only a motor that was idle begins anew. */
inline beginStop() {
    disarm(); latch = false; rounds = 0; turn = 0; reads = 0; open = true;
    EACH(MOTORS)
        if
        :: MOVING(i) -> skip
        :: else -> wanted[i] = (i < known); sent[i] = false; idle[i] = false; alarmed[i] = false; count[i] = 0;
            if :: i < known -> tell(i, REQUESTED) :: else -> skip fi
        fi; DONE
}

/* The motor is known now, and a stop is not over: it is stopped as the others are, before anything else. */
inline learn() {
    identified = true;
    if
    :: known < MOTORS && open && !wanted[LAST] ->
        known = MOTORS; wanted[LAST] = true; sent[LAST] = false; idle[LAST] = false;
        alarmed[LAST] = false; count[LAST] = 0; tell(MOTORS - 1, REQUESTED); turn = 0; reads = 0; rounds = 0
    :: else -> known = MOTORS
    fi
}
inline takeState(v) {
    EACH(known)
        if
        :: open && wanted[i] && sent[i] && !idle[i] ->
            if
            :: v & (1 << i) -> count[i] = 0
            :: else -> count[i]++;
                if
                :: count[i] == READINGS -> assert(!drives[i]); idle[i] = true; tell(i, IDLE)
                :: else -> skip
                fi
            fi
        :: else -> skip
        fi; DONE; reads++
}
inline raiseAlarm() {
    EACH(MOTORS)
        if
        :: open && MOVING(i) && !alarmed[i] -> alarmed[i] = true; tell(i, ALARM)
        :: else -> skip
        fi; DONE
}
inline linkLost() { link = LOST; disarm(); latch = false; identified = false; attempts = 0 }
inline answered(k, v) {
    if
    :: k == JOIN ->
        if
        :: v == 1 || link == LOST -> disarm(); latch = false; forget()
        :: else -> skip
        fi;
        link = UP; attempts = 0; turn = 0; reads = 0; fresh = false
    :: k == WHO -> learn()
    :: k == GET -> takeState(v)
    :: k == STOP -> tell(asked, ACCEPTED)
    :: else -> skip
    fi
}

inline blindStops() {
    EACH(MOTORS)
        if
        :: MOVING(i) ->
            sent[i] = true; stops = stops | (1 << i);
            if
            :: line == DEAD -> skip
            :: line == MUTE -> joined = true; fresh = false;
                if :: obeys -> drives[i] = false :: else -> skip fi
            :: else -> skip                            /* a link that can be had is had first */
            fi
        :: else -> skip
        fi; DONE; rounds++;
    if :: rounds >= ROUNDS -> raiseAlarm() :: else -> skip fi
}

/* The most urgent thing that the drive can do on a free line. */
inline work() {
    if
    :: link != UP && open && EXCLUSIVE && BLIND && rounds < ROUNDS + 1 ->  /* without waiting for any */
        blindStops()
    :: link != UP && !(open && EXCLUSIVE && BLIND && rounds < ROUNDS + 1) -> ask(JOIN, 0)
    :: link == UP && open && turn < MOTORS && MOVING(turn) ->
        ask(STOP, turn); sent[turn] = true; stops = stops | (1 << turn); turn++
    :: link == UP && open && turn < MOTORS && !MOVING(turn) -> turn++
    :: link == UP && open && turn >= MOTORS && EXCLUSIVE && reads < READINGS -> ask(GET, 0)
    :: link == UP && open && turn >= MOTORS && EXCLUSIVE && reads >= READINGS && (identified || !ANYALARM) ->
        rounds++; turn = 0; reads = 0;
        if :: rounds >= ROUNDS -> rounds = ROUNDS; raiseAlarm() :: else -> skip fi
    :: link == UP && !identified && !(open && (turn < MOTORS || (EXCLUSIVE && !(ANYALARM && reads >= READINGS)))) ->
        ask(WHO, 0)
    :: link == UP && identified && !EXCLUSIVE && !(open && turn < MOTORS) && startWanted ->
        assert(armed && latch); startWanted = false;   /* no other way may start a motor */
        if :: LOOKS_FIRST && drives[subject] -> skip :: else -> starts = starts | (1 << subject); ask(START, subject) fi
    :: else -> wantsStop = false; beginStop()          /* nothing but that is left */
    fi
}

inline finish() {
    EACH(MOTORS)
        if
        :: open && wanted[i] ->
            assert(idle[i] || alarmed[i]);
            assert(idle[i] || line == DEAD || line == MUTE || !obeys)
        :: else -> skip
        fi; DONE;
    if :: open && (line == CLEAN || line == NOISY) && obeys -> assert(!drives[0] && !drives[LAST]) :: else -> skip fi;
    printf("end link=%e armed=%d starts=%d stops=%d told=%d,%d run=%d,%d\n", link, armed, starts, stops,
        told[0], told[LAST], drives[0], drives[LAST]);
    if :: open && !EXCLUSIVE -> open = false :: else -> skip fi;
    if
    :: !open -> wanted[0] = false; sent[0] = false; idle[0] = false; alarmed[0] = false; count[0] = 0;
        wanted[LAST] = false; sent[LAST] = false; idle[LAST] = false;
        alarmed[LAST] = false; count[LAST] = 0
    :: else -> skip
    fi;
    rounds = 0; turn = 0; reads = 0; attempts = 0; asked = 0; m = 0; k = 0; value = 0; fate = DELIVERED;
    answers = false; expires = false; subject = 0; startFate = DELIVERED; obeys = true; gaveUp = false;
    told[0] = 0; told[LAST] = 0; starts = 0; stops = 0; calm = true; act = NOTHING; line = CLEAN
}

/* Nothing is left to do. A line without answers is given up once; a stop that is not obeyed goes on for ever. */
#define SETTLED (waiting == 0 && QUIET && !wantsStop && !(startWanted && link == UP) && \
    ((link == UP && identified && (!EXCLUSIVE || (STUCK && !obeys)) && !needsLook) || \
     (link == LOST && (line == DEAD || line == MUTE) && (!EXCLUSIVE || !BLIND || rounds > ROUNDS) && (!EXCLUSIVE || ALLALARM) \
        && gaveUp && !needsLook)))

/* A user who means to press Stop does so in the end. */
#define GOESON (!(SETTLED) && !needsLook && !(wantsStop && (gaveUp || ALLALARM)))

#define RUNS (!calm && !(wantsStop && act == DOSTOP))  /* a lone Stop is the first thing that happens */

active proctype Drive() {
    mtype k, fate = DELIVERED; byte m, value, i; byte asked; bool answers, expires;
    do
    :: atomic { RUNS && len(down) > 0 && !expires -> down?k,m,value;
        if
        :: k == NOTICE -> disarm(); latch = false; identified = false; link = LOST; waiting = 0; attempts = 0
        :: k == waiting && m == asked -> waiting = 0; answered(k, value)
        :: else -> skip                                /* twice, or too late */
        fi }
    :: atomic { RUNS && waiting != 0 && (QUIET || expires) -> /* no answer came in time */
        waiting = 0; expires = false; startWanted = false; attempts++;
        if
        :: link == UP -> link = MENDING
        :: link != UP && (attempts > ATTEMPTS || link == LOST) && (line == DEAD || line == MUTE) ->
            linkLost(); gaveUp = true;
            if :: open && EXCLUSIVE -> raiseAlarm() :: else -> skip fi
        :: else -> skip
        fi }
    :: atomic { RUNS && waiting == 0 && len(down) == 0 && GOESON -> work() }
    :: atomic { RUNS && waiting == 0 && len(down) == 0 && needsLook -> needsLook = false;
        if :: link == UP && identified && !startWanted -> ask(GET, 0) :: else -> skip fi }
    :: atomic { !calm && wantsStop -> wantsStop = false; beginStop() }
    :: atomic { RUNS && SETTLED -> finish() };
        progress: skip
    od
}

active proctype Person() {
    do
    :: atomic { calm ->
        if :: act = NOTHING :: act = ARM :: act = DOSTART :: act = DOSTOP :: act = DOBOTH fi;
        if :: line = CLEAN :: line = NOISY :: line = DEAD :: line = MUTE fi;
        if :: subject = 0 :: subject = MOTORS - 1 fi;
        if :: (act == DOSTART || act == DOBOTH) && (line == DEAD || line == MUTE) -> line = CLEAN :: else -> skip fi;
        if :: !(open && line == MUTE) -> obeys = true :: act != DOBOTH -> obeys = false fi;  /* else it is a race */
        if :: act == NOTHING || act == DOSTOP -> wasReset = true :: wasReset = false fi;
        startFate = DELIVERED;
        if :: line == NOISY && act == DOSTART ->
            if :: startFate = ASKLOST :: startFate = ANSWERLOST :: startFate = DELIVERED fi
           :: else -> skip
        fi;
        faults = (line != NOISY -> 0 : (act == DOSTART -> START_FAULTS : FAULTS));
        printf("phase act=%e motor=%d line=%e obeys=%d reset=%d start=%e\n", act, subject + 1, line, obeys, wasReset,
            startFate);
        if
        :: wasReset -> drives[0] = false; drives[LAST] = false; joined = false; fresh = KNOWS_RESET;
            if :: SAYS_RESET && line != DEAD && line != MUTE -> down!NOTICE,0,0 :: else -> skip fi
        :: else -> skip
        fi;
        if
        :: act == ARM && link == UP && identified && !EXCLUSIVE -> armed = true; latch = true; open = false
        :: (act == DOSTART || act == DOBOTH) && armed -> startWanted = true; wantsStop = (act == DOBOTH)
        :: (act == DOBOTH) && !armed -> wantsStop = true
        :: act == DOSTOP -> wantsStop = true
        :: else -> skip
        fi;
        wasReset = false; gaveUp = false; needsLook = true; calm = false }
    od
}
